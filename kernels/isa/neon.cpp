// SPDX-License-Identifier: BSD-3-Clause
/// Kernels for NEON, which every 64-bit ARM processor has.
#include <xsimd/xsimd.hpp>

#define SCARP_ARCH xsimd::neon64
#define SCARP_ISA Isa::neon
#define SCARP_ISA_NAME "neon"
#define SCARP_TABLE neon_kernels
#include "kernels/isa/instantiate.inl"
