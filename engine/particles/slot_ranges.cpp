// SPDX-License-Identifier: BSD-3-Clause
/// Blocks that follow each other become one range.
#include "engine/particles/slot_ranges.hpp"

#include "engine/parallel.hpp"

namespace scarp {

SlotRanges::SlotRanges(int threads, const std::vector<ParticleGroup>& groups,
                       std::span<const std::uint8_t> chosen)
    : all_(false) {
  std::vector<Range> of_group;
  for (const ParticleGroup& group : groups) {
    first_.push_back(ranges_.size());
    parallel_gather(threads, group.capacity, particle_chunk, of_group,
                    [&](std::int64_t begin, std::int64_t end, auto& out) {
                      for (std::int64_t slot = group.first + begin; slot < group.first + end;
                           slot += block_size) {
                        if (chosen[static_cast<std::size_t>(slot / block_size)] == 0) continue;
                        if (out.empty() || out.back().end != slot) out.push_back({slot, slot});
                        out.back().end = slot + block_size;
                      }
                    });
    ranges_.insert(ranges_.end(), of_group.begin(), of_group.end());
  }
  first_.push_back(ranges_.size());
}

}  // namespace scarp
