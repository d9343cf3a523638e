// SPDX-License-Identifier: BSD-3-Clause
/// Sorts slots by the key of their cell.
#include "engine/cells/radix_sort.hpp"

#include <algorithm>
#include <array>

#include "engine/parallel.hpp"

namespace scarp {
namespace {

constexpr int bits = 11;
constexpr std::uint64_t mask = (1u << bits) - 1;

/// How many items of a chunk have each digit, then where the next of them goes.
using Places = std::array<std::uint32_t, mask + 1>;

/// One thread sums up what the chunks have counted: at most so many chunks, none of few items.
constexpr std::int64_t most_chunks = 64, smallest_chunk = 1 << 14;

/// Items of a digit go behind those of smaller digits; within it those of earlier chunks come
/// first.
void place_behind_each_other(std::vector<Places>& chunks) {
  std::uint32_t next = 0;
  for (std::size_t digit = 0; digit <= mask; ++digit) {
    for (Places& places : chunks) {
      const std::uint32_t count = places[digit];
      places[digit] = next;
      next += count;
    }
  }
}

}  // namespace

void sort_by_key(int threads, std::vector<KeyedSlot>& items, std::vector<KeyedSlot>& scratch) {
  const std::int64_t count = std::ssize(items);
  if (count == 0) return;
  scratch.resize(items.size());
  const std::int64_t chunk = std::max(smallest_chunk, (count + most_chunks - 1) / most_chunks);
  std::vector<Places> places(static_cast<std::size_t>((count + chunk - 1) / chunk));
  const auto each = [&](const auto& visit) {
    parallel_chunks(threads, count, chunk, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t k = begin; k < end; ++k)
        visit(places[static_cast<std::size_t>(begin / chunk)], items[static_cast<std::size_t>(k)]);
    });
  };
  const std::uint64_t differing = parallel_reduce(
      threads, count, chunk, std::uint64_t{0},
      [&](std::int64_t begin, std::int64_t end) {
        std::uint64_t bits_here = 0;
        for (std::int64_t k = begin; k < end; ++k)
          bits_here |= items[static_cast<std::size_t>(k)].key ^ items.front().key;
        return bits_here;
      },
      [](std::uint64_t& all, std::uint64_t part) { all |= part; });
  for (int shift = 0; shift < 63; shift += bits) {
    if ((differing >> shift & mask) == 0) continue;
    for (Places& of_chunk : places) of_chunk.fill(0);
    each(
        [shift](Places& of_chunk, const KeyedSlot& item) { ++of_chunk[item.key >> shift & mask]; });
    place_behind_each_other(places);
    each([shift, &scratch](Places& of_chunk, const KeyedSlot& item) {
      scratch[of_chunk[item.key >> shift & mask]++] = item;
    });
    items.swap(scratch);
  }
}

}  // namespace scarp
