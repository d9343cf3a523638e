// SPDX-License-Identifier: BSD-3-Clause
/// Sorts slots by the key of their cell.
#pragma once

#include <cstdint>

#include "engine/particles/aligned_vector.hpp"

namespace scarp {

struct KeyedSlot {
  std::uint64_t key;
  std::int32_t slot;
};

/// Stable radix sort by keys below 2^63, on `threads` threads, whose number changes nothing. Digits
/// that are equal everywhere are skipped. Limits: fewer than 2^32 items.
void sort_by_key(int threads, RawVector<KeyedSlot>& items, RawVector<KeyedSlot>& scratch);

}  // namespace scarp
