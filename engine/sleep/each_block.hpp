// SPDX-License-Identifier: BSD-3-Clause
/// Goes over blocks of soil on several threads.
#pragma once

#include <cstdint>

#include "engine/parallel.hpp"
#include "engine/particles/slot_ranges.hpp"

namespace scarp {

/// Blocks that a thread takes at once.
inline constexpr std::int64_t blocks_at_once = 32;

/// Calls visit(block) for blocks 0 .. blocks - 1, in any order.
template <class Visit>
void each_block(int threads, std::int64_t blocks, const Visit& visit) {
  parallel_chunks(threads, blocks, blocks_at_once, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t block = begin; block < end; ++block) visit(static_cast<std::int32_t>(block));
  });
}

}  // namespace scarp
