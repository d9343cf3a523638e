// SPDX-License-Identifier: BSD-3-Clause
/// Kernels for SSE2.
#include <xsimd/xsimd.hpp>

#define SCARP_GENERAL_SET
#define SCARP_ARCH xsimd::sse2
#define SCARP_ISA Isa::sse2
#define SCARP_ISA_NAME "sse2"
#define SCARP_TABLE sse2_kernels
#include "kernels/isa/instantiate.inl"
