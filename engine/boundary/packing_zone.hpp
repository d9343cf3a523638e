// SPDX-License-Identifier: BSD-3-Clause
/// Which soil is packed anew beside walls that the lattice does not meet.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "engine/boundary/wall_surface.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// What moves, and what it leans on. Where a body ends before a wall does, empty sites of the
/// lattice go on beyond its surface, so that the surface neither swells nor sinks.
struct PackingZone {
  std::vector<std::size_t> soil;  ///< particles that move, ascending
  std::vector<Vec3> empty_sites;  ///< that move with them [m]
  std::vector<Vec3> standing;     ///< soil and empty sites that stay [m]
};

/// Soil within `reach` of a face that the lattice does not meet. A lattice meets a face where all
/// soil nearer than a spacing is half a spacing away. Pre: `soil` stands on one lattice of the
/// scene's spacing.
PackingZone packing_zone(const Scene& scene, const WallSurface& surface,
                         const std::vector<Vec3>& soil, double reach,
                         const std::function<bool()>& stop);

}  // namespace scarp
