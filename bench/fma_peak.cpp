// SPDX-License-Identifier: BSD-3-Clause
/// Times the multiply-adds of `fma_peak_isa.cpp`.
#include "bench/fma_peak.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <map>

namespace scarp::bench {
namespace {

double measure(FmaWork (*work)(std::int64_t)) {
  using Clock = std::chrono::steady_clock;
  double best = 0.0;
  for (int burst = 0; burst < 50; ++burst) {
    const auto start = Clock::now();
    const FmaWork done = work(300'000);
    const std::chrono::duration<double> seconds = Clock::now() - start;
    benchmark::DoNotOptimize(done.result);
    best = std::max(best, done.flops / seconds.count());
  }
  return best;
}

}  // namespace

double fma_peak(kernels::Isa isa) {
  static std::map<kernels::Isa, double> known;
  if (const auto at = known.find(isa); at != known.end()) return at->second;
#if defined(__aarch64__)
  return known[isa] = measure(fma_peak_neon);
#else
  FmaWork (*const work[])(std::int64_t) = {fma_peak_sse2, fma_peak_avx2, fma_peak_avx512};
  return known[isa] = measure(work[static_cast<int>(isa)]);
#endif
}

}  // namespace scarp::bench
