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
  return !below_its_layers &&
         at.distance(facet) <= std::sqrt(static_cast<double>(dimension)) * thickness;
}

bool CornerReach::faces_back(const Facet& facet, const Vec3& outward) {
  return dot(facet.normal, outward) < -1e-6;
}

bool stands_in_corner(const Scene& scene, const CornerReach& reach, const SmoothCorner& corner,
                      const Vec3& point, const std::vector<bool>& stands,
                      const std::vector<Vec3>& offset) {
  const auto is_closed = [&](const Vec3& outward) {
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
      if (scene.walls[w].kind != WallKind::free_slip || !stands[w]) continue;
      const Vec3 from_wall = minus(point, offset[w]);
      for (const Facet& facet : scene.walls[w].facets) {
        if (CornerReach::faces_back(facet, outward) && reach.is_near(facet, from_wall)) return true;
      }
    }
    return false;
  };
  return std::all_of(corner.over.begin(), corner.over.end(),
                     [&](const Vec3& outward) { return outward == Vec3{} || is_closed(outward); });
}

bool stay_together(const Wall& own, const Wall& other) {
  const bool same_way = own.velocity == other.velocity &&
                        (own.velocity == Vec3{} || own.moves_from == other.moves_from);
  return same_way && (other.removed_at.empty() || other.removed_at == own.removed_at);
}

bool may_come_near(const Scene& scene, const CornerReach& reach, const Vec3& point, const Wall& own,
                   const Wall& other, const Facet& facet) {
  // Either may move while the other waits: the way is anywhere between these two.
  double longest = 0.0;
  for (const Stage& stage : scene.stages) longest += stage.duration.value_or(1e30);
  const double margin = std::sqrt(static_cast<double>(scene.dimension)) * reach.thickness;
  Vec3 low{}, high{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double ways[2] = {longest * own.velocity[a], -longest * other.velocity[a]};
    low[a] = point[a] + std::min(ways[0], 0.0) + std::min(ways[1], 0.0) - margin;
    high[a] = point[a] + std::max(ways[0], 0.0) + std::max(ways[1], 0.0) + margin;
    const double u = facet.length_u * facet.tangent_u[a], v = facet.length_v * facet.tangent_v[a];
    const double least = facet.origin[a] + std::min(u, 0.0) + std::min(v, 0.0);
    const double most = facet.origin[a] + std::max(u, 0.0) + std::max(v, 0.0);
    if (most < low[a] || least > high[a]) return false;
  }
  return true;
}

}  // namespace scarp
