// SPDX-License-Identifier: BSD-3-Clause
/// Rough walls that meet free-slip faces.
#include "engine/boundary/smooth_corner.hpp"

#include <algorithm>
#include <cmath>

#include "engine/boundary/dummies.hpp"
#include "engine/boundary/facet_geometry.hpp"

namespace scarp {

using namespace geometry;

CornerReach corner_reach(const Scene& scene) {
  return {scene.dimension, static_cast<double>(wall_layers(scene)) * scene.spacing,
          1e-6 * scene.spacing};
}

bool CornerReach::is_near(const Facet& facet, const Vec3& point) const {
  const FacetCoordinates at = coordinates(facet, dimension, point);
  const bool below_its_layers = at.depth > thickness && at.above(facet, tolerance);
  return !below_its_layers && at.distance(facet) <= farthest();
}

double CornerReach::farthest() const {
  return std::sqrt(static_cast<double>(dimension)) * thickness;
}

bool CornerReach::faces_back(const Facet& facet, const Vec3& outward) {
  return dot(facet.normal, outward) < -1e-6;
}

bool stands_in_corner(const Scene& scene, const WallSurface& surface, const CornerReach& reach,
                      const SmoothCorner& corner, const Vec3& point, const WallPlacement& walls,
                      FacetSearch& search) {
  const auto near = surface.near(point, reach.farthest() + reach.tolerance, walls, search);
  const auto is_closed = [&](const Vec3& outward) {
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t face) {
      const std::size_t w = surface.wall_of(face);
      return scene.walls[w].kind == WallKind::free_slip &&
             CornerReach::faces_back(surface.facet(face), outward) &&
             reach.is_near(surface.facet(face), minus(point, walls.offset[w]));
    });
  };
  return std::all_of(corner.over.begin(), corner.over.end(),
                     [&](const Vec3& outward) { return outward == Vec3{} || is_closed(outward); });
}

bool stay_together(const Wall& own, const Wall& other) {
  const bool same_way = own.velocity == other.velocity &&
                        (own.velocity == Vec3{} || own.moves_from == other.moves_from);
  return same_way && (other.removed_at.empty() || other.removed_at == own.removed_at);
}

AxisBox way_between(const Scene& scene, const CornerReach& reach, const Vec3& point,
                    const Wall& own, const Wall& other) {
  // Either may move while the other waits: the way is anywhere between these two.
  double longest = 0.0;
  for (const Stage& stage : scene.stages) longest += stage.duration.value_or(1e30);
  const double margin = reach.farthest();
  AxisBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    const double ways[2] = {longest * own.velocity[a], -longest * other.velocity[a]};
    box.low[a] = point[a] + std::min(ways[0], 0.0) + std::min(ways[1], 0.0) - margin;
    box.high[a] = point[a] + std::max(ways[0], 0.0) + std::max(ways[1], 0.0) + margin;
  }
  return box;
}

}  // namespace scarp
