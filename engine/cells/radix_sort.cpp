// SPDX-License-Identifier: BSD-3-Clause
/// Sorts slots by the key of their cell.
#include "engine/cells/radix_sort.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>

#include "engine/parallel.hpp"

namespace scarp {
namespace {

constexpr int bits = 11;
constexpr std::size_t digits = std::size_t{1} << bits;

/// Items that are counted together: some for each digit, else the counts cost more than the items.
constexpr std::int64_t chunk_size = 1 << 13;

/// Digits that a thread takes at once.
constexpr std::int64_t digits_at_once = 64;

/// By digit: how many items of a chunk have it, then where the next of them goes.
using Places = std::array<std::uint32_t, digits>;

/// Counts become places among all items of the digit. Returns how many these are.
Places places_within_digits(int threads, RawVector<Places>& chunks) {
  Places sum{};
  parallel_chunks(threads, digits, digits_at_once, [&](std::int64_t begin, std::int64_t end) {
    for (Places& places : chunks) {
      for (auto digit = static_cast<std::size_t>(begin); digit < static_cast<std::size_t>(end);
           ++digit)
        sum[digit] += std::exchange(places[digit], sum[digit]);
    }
  });
  return sum;
}

}  // namespace

void sort_by_key(int threads, RawVector<KeyedSlot>& items, RawVector<KeyedSlot>& scratch) {
  const std::int64_t count = std::ssize(items);
  if (count == 0) return;
  scratch.resize(items.size());
  RawVector<Places> places(static_cast<std::size_t>((count + chunk_size - 1) / chunk_size));
  /// visit(places of the chunk, its items)
  const auto each_chunk = [&](const auto& visit) {
    parallel_chunks(threads, count, chunk_size, [&](std::int64_t begin, std::int64_t end) {
      visit(places[static_cast<std::size_t>(begin / chunk_size)],
            std::span(items).subspan(static_cast<std::size_t>(begin),
                                     static_cast<std::size_t>(end - begin)));
    });
  };
  const std::uint64_t differing = parallel_reduce(
      threads, count, chunk_size, std::uint64_t{0},
      [&](std::int64_t begin, std::int64_t end) {
        std::uint64_t bits_here = 0;
        for (std::int64_t k = begin; k < end; ++k)
          bits_here |= items[static_cast<std::size_t>(k)].key ^ items.front().key;
        return bits_here;
      },
      [](std::uint64_t& all, std::uint64_t part) { all |= part; });
  for (int shift = 0; shift < 63; shift += bits) {
    const auto digit = [shift](const KeyedSlot& item) { return item.key >> shift & (digits - 1); };
    if ((differing >> shift & (digits - 1)) == 0) continue;
    each_chunk([&](Places& of_chunk, std::span<const KeyedSlot> chunk) {
      of_chunk.fill(0);
      for (const KeyedSlot& item : chunk) ++of_chunk[digit(item)];
    });
    Places first = places_within_digits(threads, places);
    put_behind_each_other(first);
    each_chunk([&](Places& of_chunk, std::span<const KeyedSlot> chunk) {
      for (std::size_t k = 0; k < digits; ++k) of_chunk[k] += first[k];
      for (const KeyedSlot& item : chunk) scratch[of_chunk[digit(item)]++] = item;
    });
    items.swap(scratch);
  }
}

}  // namespace scarp
