// SPDX-License-Identifier: BSD-3-Clause
/// Neighbour lists in blocks, 20 bytes for eight entries.
#include "engine/neighbours/neighbour_blocks.hpp"

#include <algorithm>

namespace scarp {

using kernels::entry_block;
using kernels::no_neighbour;

void NeighbourBlocks::turn_to(std::int32_t page_begin) {
  const std::size_t blocks = (place_.size() + entry_block - 1) / entry_block;
  place_.resize(blocks * entry_block, no_neighbour);
  page_.resize(blocks, page_begin_);
  page_begin_ = page_begin;
}

void NeighbourBlocks::append_empty(std::int64_t blocks) {
  page_.insert(page_.end(), static_cast<std::size_t>(blocks), 0);
  place_.insert(place_.end(), static_cast<std::size_t>(blocks * entry_block), no_neighbour);
}

void NeighbourBlocks::reserve(std::int64_t blocks) {
  page_.reserve(static_cast<std::size_t>(blocks));
  place_.reserve(static_cast<std::size_t>(blocks * entry_block));
}

void NeighbourBlocks::resize(std::int64_t blocks) {
  page_.clear();  // so that nothing is copied
  place_.clear();
  reserve(blocks + 2);  // for the empty ones that end all lists
  page_.resize(static_cast<std::size_t>(blocks));
  place_.resize(static_cast<std::size_t>(blocks * entry_block));
}

void NeighbourBlocks::copy(const NeighbourBlocks& from, std::int64_t to_block) {
  std::copy(from.page_.begin(), from.page_.end(), page_.begin() + to_block);
  std::copy(from.place_.begin(), from.place_.end(), place_.begin() + to_block * entry_block);
}

std::size_t NeighbourBlocks::bytes() const {
  return page_.size() * sizeof(std::int32_t) + place_.size() * sizeof(std::uint16_t);
}

}  // namespace scarp
