// SPDX-License-Identifier: BSD-3-Clause
/// Blocks that follow each other become one range.
#include "engine/particles/slot_ranges.hpp"

#include "engine/parallel.hpp"

namespace scarp {

SlotRanges::SlotRanges(const std::vector<ParticleGroup>& groups,
                       std::span<const std::uint8_t> chosen)
    : all_(false) {
  for (const ParticleGroup& group : groups) {
    first_.push_back(ranges_.size());
    for (std::int64_t slot = group.first; slot < group.padded_end(); slot += block_size) {
      if (chosen[static_cast<std::size_t>(slot / block_size)] == 0) continue;
      const bool goes_on = ranges_.size() > first_.back() && ranges_.back().end == slot &&
                           (slot - group.first) % particle_chunk != 0;
      if (!goes_on) ranges_.push_back({slot, slot});
      ranges_.back().end = slot + block_size;
    }
  }
  first_.push_back(ranges_.size());
}

}  // namespace scarp
