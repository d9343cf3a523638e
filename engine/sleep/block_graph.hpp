// SPDX-License-Identifier: BSD-3-Clause
/// Which blocks of soil are near each other, and which dummies near them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/particles/aligned_vector.hpp"

namespace scarp {

struct State;

/// For each of some items the soil blocks that its neighbour lists name.
class BlockLists {
 public:
  BlockLists() = default;
  /// The blocks of all items, and how many each has.
  BlockLists(std::vector<std::size_t> sizes, RawVector<std::int32_t> blocks);
  std::int64_t size() const { return static_cast<std::int64_t>(begin_.size()) - 1; }
  std::span<const std::int32_t> operator[](std::int64_t item) const {
    const std::size_t k = static_cast<std::size_t>(item), first = begin_[k];
    return std::span(blocks_).subspan(first, begin_[k + 1] - first);
  }

 private:
  std::vector<std::size_t> begin_{0};
  RawVector<std::int32_t> blocks_;
};

/// Made of the neighbour lists whenever they are built. An image counts as the soil it is one of.
/// Pre: all soil is here, without ghosts.
struct BlockGraph {
  BlockLists soil;   ///< by block of soil, itself included
  BlockLists walls;  ///< by active cluster of dummies
  /// By block: 1 where a wall moves near it.
  std::vector<std::uint8_t> driven;
};

BlockGraph make_block_graph(const State& state);

}  // namespace scarp
