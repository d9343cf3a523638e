// SPDX-License-Identifier: BSD-3-Clause
/// Peak of double-precision multiply-adds of one core, which shares of peak refer to.
#pragma once

#include <cstdint>

#include "kernels/isa/kernel_table.hpp"

namespace scarp::bench {

struct FmaWork {
  double result;  ///< so that the work is not optimised away
  double flops;
};
FmaWork fma_peak_sse2(std::int64_t rounds);
FmaWork fma_peak_avx2(std::int64_t rounds);
FmaWork fma_peak_avx512(std::int64_t rounds);
FmaWork fma_peak_neon(std::int64_t rounds);

/// Best of 50 bursts of a few milliseconds [flop/s], measured once per instruction set and run.
double fma_peak(kernels::Isa isa);

}  // namespace scarp::bench
