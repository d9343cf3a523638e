// SPDX-License-Identifier: BSD-3-Clause
/// Writing of neighbour lists.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/particles/aligned_vector.hpp"
#include "engine/particles/record_layout.hpp"
#include "kernels/particle_view.hpp"

namespace scarp {

/// Blocks of records as kernels::NeighbourView describes them, 20 bytes for eight records.
class NeighbourBlocks {
 public:
  /// Adds a neighbour to the list that `end_list` will end. A change of the page fills up the block
  /// at hand, so records of a page should follow each other.
  void add(std::int32_t record) {
    if (!in_page(record, page_begin_)) turn_to(page_of(record));
    place_.push_back(static_cast<std::uint16_t>(record - page_begin_));
  }
  /// Fills up the last block.
  void end_list() { turn_to(page_begin_); }
  /// Appends blocks without neighbours.
  void append_empty(std::int64_t blocks);
  void reserve(std::int64_t blocks);
  /// Makes `blocks` blocks without values, to be filled by `copy`, and room for two more.
  void resize(std::int64_t blocks);
  void copy(const NeighbourBlocks& from, std::int64_t to_block);

  std::int64_t size() const { return static_cast<std::int64_t>(page_.size()); }
  std::span<const std::int32_t> page() const { return page_; }
  std::span<const std::uint16_t> place() const { return place_; }
  std::size_t bytes() const;

 private:
  void turn_to(std::int32_t page_begin);

  RawVector<std::int32_t> page_;
  RawVector<std::uint16_t> place_;
  std::int32_t page_begin_ = 0;
};

}  // namespace scarp
