// SPDX-License-Identifier: BSD-3-Clause
/// The one place that starts threads.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <vector>

namespace scarp {

/// Calls f(begin, end) for consecutive chunks of [0, count), on `threads` threads, in any order.
/// Chunks do not depend on the thread count, so neither does any result. Errors: the first one that
/// f throws (no exception may leave an OpenMP region); chunks that have not begun by then are left
/// out.
template <class F>
void parallel_chunks(int threads, std::int64_t count, std::int64_t chunk, F&& f) {
  const std::int64_t chunks = (count + chunk - 1) / chunk;
  std::atomic<bool> failed = false;
  std::exception_ptr first;
#pragma omp parallel for num_threads(threads) schedule(dynamic, 1) if (threads > 1 && chunks > 1)
  for (std::int64_t c = 0; c < chunks; ++c) {
    if (failed.load(std::memory_order_relaxed)) continue;
    try {
      f(c * chunk, std::min(count, (c + 1) * chunk));
    } catch (...) {
      if (!failed.exchange(true)) first = std::current_exception();
    }
  }
  if (first) std::rethrow_exception(first);
}

/// The same with a partial result per chunk, merged in order of the chunks: merge(total, partial).
template <class Result, class F, class Merge>
Result parallel_reduce(int threads, std::int64_t count, std::int64_t chunk, Result start, F&& f,
                       Merge&& merge) {
  std::vector<Result> partial(static_cast<std::size_t>((count + chunk - 1) / chunk), start);
  parallel_chunks(threads, count, chunk, [&](std::int64_t begin, std::int64_t end) {
    partial[static_cast<std::size_t>(begin / chunk)] = f(begin, end);
  });
  for (const auto& part : partial) merge(start, part);
  return start;
}

/// What OpenMP would take: OMP_NUM_THREADS, else every core.
inline int offered_threads() { return omp_get_max_threads(); }

/// Cores that the process was given when it began.
inline int offered_cores() { return omp_get_num_procs(); }

/// Particles per chunk: a multiple of every vector and cluster size, small enough for the
/// second-level cache.
inline constexpr std::int64_t particle_chunk = 1024;

}  // namespace scarp
