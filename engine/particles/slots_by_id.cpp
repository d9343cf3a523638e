// SPDX-License-Identifier: BSD-3-Clause
/// Particles in the order of their permanent ids.
#include "engine/particles/slots_by_id.hpp"

#include <algorithm>
#include <iterator>

namespace scarp {

std::vector<std::int64_t> slots_by_id(const ParticleBuffers& particles) {
  const auto id_of = [&ids = particles.ids()](std::int64_t slot) {
    return ids[static_cast<std::size_t>(slot)];
  };
  std::vector<std::int64_t> slots;
  std::int64_t last = -1;
  for (const ParticleGroup& group : particles.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      slots.push_back(k);
      last = std::max(last, id_of(k));
    }
  }
  if (last + 1 == std::ssize(slots)) {  // no gaps: each id is a place
    const std::vector<std::int64_t> all = slots;
    for (const std::int64_t slot : all) slots[static_cast<std::size_t>(id_of(slot))] = slot;
    return slots;
  }
  std::sort(slots.begin(), slots.end(),
            [&](std::int64_t a, std::int64_t b) { return id_of(a) < id_of(b); });
  return slots;
}

}  // namespace scarp
