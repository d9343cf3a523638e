// SPDX-License-Identifier: BSD-3-Clause
/// The part of a facet between the facets that stand on it.
#include "engine/boundary/walled_part.hpp"

#include <algorithm>
#include <cmath>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/smooth_corner.hpp"

namespace scarp {

using namespace geometry;

WalledPart walled_part(std::uint32_t face, const WallSurface& surface, const Scene& scene,
                       double least) {
  const int dimension = scene.dimension;
  const Facet& own = surface.facet(face);
  const Wall& own_wall = scene.walls[surface.wall_of(face)];
  const double tolerance = 1e-6 * least;
  const std::array<Vec3, 2> tangent{own.tangent_u, own.tangent_v};
  const std::array<double, 2> length{own.length_u, own.length_v};
  WalledPart part{{{0.0, length[0]}, {0.0, length[1]}}};
  FacetSearch search;
  for (const std::uint32_t k : surface.near(own, least, search)) {
    if (k == face || !stay_together(own_wall, scene.walls[surface.wall_of(k)])) continue;
    const Facet& other = surface.facet(k);
    for (std::size_t a = 0; a + 1 < static_cast<std::size_t>(dimension); ++a) {
      const double facing = dot(other.normal, tangent[a]);
      if (std::abs(facing) < 0.5 || std::abs(dot(other.normal, tangent[1 - a])) > 1e-6) continue;
      const double along = dot(minus(other.origin, own.origin), other.normal) / facing;
      if (along < -tolerance || along > length[a] + tolerance) continue;
      const Vec3 across = plus(own.origin, 0.5 * length[1 - a], tangent[1 - a]);
      const Vec3 foot = plus(across, along, tangent[a]);
      // It must rise from the face: at the edge of a step it goes down.
      const Vec3 rise = minus(own.normal, plus({}, dot(own.normal, other.normal), other.normal));
      const Vec3 above = plus(foot, 0.25 * least, rise);
      if (!coordinates(other, dimension, above).above(other, tolerance)) continue;
      if (facing > 0.0) {
        part[a][0] = std::max(part[a][0], along);
      } else {
        part[a][1] = std::min(part[a][1], along);
      }
    }
  }
  for (std::size_t a = 0; a + 1 < static_cast<std::size_t>(dimension); ++a) {
    if (part[a][1] - part[a][0] < least) part[a] = {0.0, length[a]};
  }
  return part;
}

}  // namespace scarp
