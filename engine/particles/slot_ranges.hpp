// SPDX-License-Identifier: BSD-3-Clause
/// Which slots of the particles a phase goes over: all, or those of chosen blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/particles/particle_buffers.hpp"

namespace scarp {

/// Slots that fall asleep and wake together: no group, vector or cluster crosses such a block.
inline constexpr std::int64_t block_size = group_alignment;

/// Chosen slots in ascending order; by default every one. `engine/particles/each_slot.hpp` goes
/// over them.
class SlotRanges {
 public:
  struct Range {
    std::int64_t begin, end;
  };

  SlotRanges() = default;
  /// Those of the blocks for which `chosen` is not 0.
  SlotRanges(int threads, const std::vector<ParticleGroup>& groups,
             std::span<const std::uint8_t> chosen);

  bool all() const { return all_; }
  bool none() const { return !all_ && ranges_.empty(); }
  /// Pre: not all().
  std::span<const Range> ranges() const { return ranges_; }
  /// ... of the group with this index.
  std::span<const Range> ranges_of(std::size_t group) const {
    return ranges().subspan(first_[group], first_[group + 1] - first_[group]);
  }

 private:
  bool all_ = true;
  std::vector<Range> ranges_;       ///< none crosses a chunk of its group
  std::vector<std::size_t> first_;  ///< by group, and one more
};

}  // namespace scarp
