// SPDX-License-Identifier: BSD-3-Clause
/// Kernels for AVX2.
#include <xsimd/xsimd.hpp>

#define SCARP_ARCH xsimd::fma3<xsimd::avx2>
#define SCARP_ISA Isa::avx2
#define SCARP_ISA_NAME "avx2"
#define SCARP_TABLE avx2_kernels
#include "kernels/isa/instantiate.inl"
