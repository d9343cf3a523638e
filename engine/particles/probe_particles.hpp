// SPDX-License-Identifier: BSD-3-Clause
/// Which soil particle a probe follows.
#pragma once

#include <cstddef>

#include "engine/particles/generate.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

struct ChosenParticle {
  std::size_t id = 0;     ///< index into the soil points
  double distance = 0.0;  ///< from the probe's point [m]
  std::size_t tied = 1;   ///< particles as near as this one, itself included
};

/// The particle nearest to `probe`. Particles within 1e-6 spacings of the least distance tie; of
/// them the highest against gravity is taken, then the one with most soil within 2.1 spacings, then
/// the one nearest to the centre of all soil: rules that a mirrored scene mirrors and round-off
/// does not turn. What still ties lies symmetrically in the soil itself: the lowest x, y and z
/// decide. Errors: SceneError if the nearest one is further away than two spacings.
ChosenParticle particle_of_probe(const Scene& scene, const Particles& soil, const Probe& probe);

}  // namespace scarp
