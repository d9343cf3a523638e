// SPDX-License-Identifier: BSD-3-Clause
/// The one place that starts threads.
#pragma once

#include <omp.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <exception>
#include <iterator>
#include <utility>
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

/// Replaces each of some sizes by the sum of those before it, which is where it begins if all
/// follow one another, and returns the sum of all.
template <class Sizes>
auto put_behind_each_other(Sizes& sizes) {
  typename Sizes::value_type end = 0;
  for (auto& size : sizes) end += std::exchange(size, end);
  return end;
}

/// Replaces `all` by what f(begin, end, out) appends to `out`, another such vector, for chunks of
/// [0, count), in order of the chunks.
template <class Vector, class F>
void parallel_gather(int threads, std::int64_t count, std::int64_t chunk, Vector& all, F&& f) {
  std::vector<Vector> parts(static_cast<std::size_t>((count + chunk - 1) / chunk));
  std::vector<std::size_t> first(parts.size());
  parallel_chunks(threads, count, chunk, [&](std::int64_t begin, std::int64_t end) {
    const auto c = static_cast<std::size_t>(begin / chunk);
    f(begin, end, parts[c]);
    first[c] = parts[c].size();
  });
  all.clear();
  all.resize(put_behind_each_other(first));
  parallel_chunks(threads, std::ssize(parts), 1, [&](std::int64_t begin, std::int64_t) {
    const auto c = static_cast<std::size_t>(begin);
    const Vector part = std::move(parts[c]);  // given back here, by many threads
    std::copy(part.begin(), part.end(), all.begin() + static_cast<std::ptrdiff_t>(first[c]));
  });
}

/// What OpenMP would take: OMP_NUM_THREADS, else every core.
inline int offered_threads() { return omp_get_max_threads(); }

/// Cores that the process was given when it began.
inline int offered_cores() { return omp_get_num_procs(); }

/// Particles per chunk: a multiple of every vector and cluster size, small enough for the
/// second-level cache.
inline constexpr std::int64_t particle_chunk = 1024;

}  // namespace scarp
