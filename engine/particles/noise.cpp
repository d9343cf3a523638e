// SPDX-License-Identifier: BSD-3-Clause
/// Noise by the ids of the particles.
#include "engine/particles/noise.hpp"

#include <cstdint>

namespace scarp {
namespace {

/// Evenly spread over -1 to 1. Source: Steele, Lea and Flood (2014), splitmix64.
double noise(std::uint64_t key) {
  key = (key + 1) * 0x9E3779B97F4A7C15u;
  key = (key ^ (key >> 30)) * 0xBF58476D1CE4E5B9u;
  key = (key ^ (key >> 27)) * 0x94D049BB133111EBu;
  return static_cast<double>((key ^ (key >> 31)) >> 11) * 0x1p-52 - 1.0;
}

}  // namespace

void add_noise(ParticleBuffers& particles, double speed) {
  const auto& ids = particles.ids();
  for (int a = 0; a < particles.dimension(); ++a) {
    double* velocity = particles.component(Field::velocity, a);
    for (std::size_t slot = 0; slot < ids.size(); ++slot) {
      if (ids[slot] < 0) continue;
      velocity[slot] += speed * noise(static_cast<std::uint64_t>(3 * ids[slot] + a));
    }
  }
}

}  // namespace scarp
