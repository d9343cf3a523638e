// SPDX-License-Identifier: BSD-3-Clause
/// The soil that stands above each particle, along gravity.
#pragma once

#include <vector>

#include "engine/particles/generate.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

struct SoilAbove {
  double pressure = 0.0;   ///< its weight per area [Pa], half of the particle's own with it
  double thickness = 0.0;  ///< from the particle's centre to the free surface above [m]
};

/// For each particle what stands on it against gravity, through all materials, up to the first gap
/// of a spacing or more: what hangs above a gap carries nothing onto what lies below. Gravity along
/// an axis: the particles of the lattice column, each a cell of its own density, so that the
/// pressure differs from that of the drawn bodies only by how the cells approach their surface (at
/// most half a spacing). Gravity in any other direction: a ray through the bodies as they are
/// drawn, its ends found to dx/512. Zeros without gravity. Errors: SceneError where a height cannot
/// be found.
std::vector<SoilAbove> soil_above(const Scene& scene, const Particles& soil, int threads);

/// Unit vector against gravity; zeros without gravity.
Vec3 upward(const Scene& scene);

}  // namespace scarp
