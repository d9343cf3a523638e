// SPDX-License-Identifier: BSD-3-Clause
/// Dummies near free edges.
#include "engine/boundary/wall_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/boundary/dummies.hpp"
#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/near_test.hpp"

namespace scarp {

using namespace geometry;

std::vector<bool> near_edges(const Scene& scene, const WallSurface& surface,
                             const std::vector<Vec3>& position, const EdgeDummies& dummies) {
  const int dimension = scene.dimension, layers = wall_layers(scene);
  const CornerReach reach = corner_reach(scene);
  const double farthest =
      std::sqrt(static_cast<double>(dimension)) * (reach.thickness + scene.spacing);
  FacetSearch search;
  NearTest placed(0.75 * scene.spacing);  // joints of facets shift columns by half a spacing
  for (const std::size_t k : dummies.near) placed.put(position[k], k);
  const auto is_behind_smooth = [&](const Vec3& point) {
    const auto found = surface.near(point, farthest, search);
    return std::any_of(found.begin(), found.end(), [&](std::uint32_t k) {
      if (scene.walls[surface.wall_of(k)].kind == WallKind::no_slip) return false;
      const Facet& facet = surface.facet(k);
      const FacetCoordinates at = coordinates(facet, dimension, point);
      return at.depth > 0.0 && at.depth <= reach.thickness && at.above(facet, reach.tolerance);
    });
  };
  const auto ends = [&](std::size_t k, const Vec3& tangent) {
    for (int step = -layers; step <= layers; ++step) {
      const Vec3 place = plus(position[k], step * scene.spacing, tangent);
      if (!placed.has_near(place, position) && !is_behind_smooth(place)) return true;
    }
    return false;
  };
  std::vector<bool> near;
  for (std::size_t k = 0; k < dummies.rim.size(); ++k) {
    const Facet* facet = dummies.rim[k];
    near.push_back(facet != nullptr &&
                   (ends(k, facet->tangent_u) || (dimension == 3 && ends(k, facet->tangent_v))));
  }
  return near;
}

}  // namespace scarp
