// SPDX-License-Identifier: BSD-3-Clause
/// Goes over chosen slots of the particles, in chunks.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>

#include "engine/parallel.hpp"
#include "engine/particles/slot_ranges.hpp"

namespace scarp {

/// Ranges that a thread takes at once: each has a block at least.
inline constexpr std::int64_t ranges_at_once = 16;

/// Calls f(begin, end) for pieces of the chosen ones of `slots` slots, padding included, as
/// `parallel_chunks` does.
template <class F>
void each_slot(int threads, const SlotRanges& which, std::int64_t slots, F&& f) {
  if (which.all()) {
    parallel_chunks(threads, slots, particle_chunk, f);
    return;
  }
  const std::span<const SlotRanges::Range> ranges = which.ranges();
  parallel_chunks(threads, std::ssize(ranges), ranges_at_once,
                  [&](std::int64_t begin, std::int64_t end) {
                    for (std::int64_t k = begin; k < end; ++k) {
                      const SlotRanges::Range& range = ranges[static_cast<std::size_t>(k)];
                      f(range.begin, range.end);
                    }
                  });
}

/// The same for the chosen slots of group number `index` below slot `end`, with a partial result
/// for each piece, merged in order: merge(total, partial). `start` is the result of no slot.
template <class Result, class F, class Merge>
Result reduce_slots(int threads, const SlotRanges& which, const ParticleGroup& group,
                    std::size_t index, std::int64_t end, Result start, F&& f, Merge&& merge) {
  if (which.all()) {
    return parallel_reduce(
        threads, end - group.first, particle_chunk, start,
        [&](std::int64_t from, std::int64_t to) { return f(group.first + from, group.first + to); },
        merge);
  }
  const std::span<const SlotRanges::Range> ranges = which.ranges_of(index);
  return parallel_reduce(
      threads, std::ssize(ranges), ranges_at_once, start,
      [&](std::int64_t from, std::int64_t to) {
        Result part = start;
        for (std::int64_t k = from; k < to; ++k) {
          const SlotRanges::Range& range = ranges[static_cast<std::size_t>(k)];
          merge(part, f(range.begin, std::min(range.end, end)));
        }
        return part;
      },
      merge);
}

}  // namespace scarp
