// SPDX-License-Identifier: BSD-3-Clause
/// Multiply-adds that nothing holds up, compiled once for each instruction set.
#include <cstdint>

#include "bench/fma_peak.hpp"

namespace scarp::bench {

/// Twelve chains hide the latency of four cycles on two units.
FmaWork SCARP_FMA_PEAK(std::int64_t rounds) {
  constexpr int lanes = SCARP_VECTOR_BYTES / 8, chains = 12;
  using Vector = double __attribute__((vector_size(SCARP_VECTOR_BYTES)));
  Vector sum[chains], factor{}, term{};
  for (int l = 0; l < lanes; ++l) {
    factor[l] = 0.999999;
    term[l] = 1e-6;
  }
  for (int c = 0; c < chains; ++c) sum[c] = term * static_cast<double>(c);
  for (std::int64_t r = 0; r < rounds; ++r) {
    for (int c = 0; c < chains; ++c) sum[c] = sum[c] * factor + term;
  }
  double result = 0.0;
  for (int c = 0; c < chains; ++c) result += sum[c][0];
  return {result, 2.0 * static_cast<double>(rounds) * chains * lanes};
}

}  // namespace scarp::bench
