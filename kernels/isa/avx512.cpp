// SPDX-License-Identifier: BSD-3-Clause
/// Kernels for AVX512.
#include <xsimd/xsimd.hpp>

#define SCARP_ARCH xsimd::avx512bw
#define SCARP_ISA Isa::avx512
#define SCARP_ISA_NAME "avx512"
#define SCARP_TABLE avx512_kernels
#include "kernels/isa/instantiate.inl"
