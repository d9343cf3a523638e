// SPDX-License-Identifier: BSD-3-Clause
/// How many particles the memory of this process can hold.
#pragma once

#include "engine/machine.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// Most resident memory a particle takes in a run [bytes], walls in the usual share: state,
/// records, lists while they are built anew, and the largest output, a checkpoint; with `retry` two
/// states are kept besides. Measured with 100 thousand particles, the dearer preset.
inline double bytes_per_particle(const Scene& scene) {
  const double two_states = scene.retries > 0 ? 2.0 * 210.0 : 0.0;
  return (scene.dimension == 2 ? 850.0 : 1400.0) + two_states;
}

/// Most particles worth starting with: more would end in the middle of the run.
inline double most_particles(const Scene& scene) {
  return usable_memory() / bytes_per_particle(scene);
}

}  // namespace scarp
