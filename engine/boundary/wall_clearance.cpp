// SPDX-License-Identifier: BSD-3-Clause
/// Finds soil that starts inside a wall.
#include "engine/boundary/wall_clearance.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "engine/boundary/dummies.hpp"
#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/facet_index.hpp"
#include "engine/errors.hpp"
#include "engine/particles/shapes.hpp"

namespace scarp {

using namespace geometry;

namespace {

/// Every facet of the scene in order, and the wall it is a part of.
struct Faces {
  std::vector<Facet> facets;
  std::vector<const Wall*> walls;

  explicit Faces(const Scene& scene) {
    for (const Wall& wall : scene.walls) {
      facets.insert(facets.end(), wall.facets.begin(), wall.facets.end());
      walls.resize(facets.size(), &wall);
    }
  }
};

}  // namespace

void check_wall_clearance(const Scene& scene, const SoilPoints& soil) {
  const double tolerance = 1e-6 * scene.spacing;
  const double thickness = wall_layers(scene) * scene.spacing;
  const Faces faces(scene);
  const FacetIndex index(faces.facets, thickness);
  std::vector<std::uint32_t> near;
  std::size_t first = faces.facets.size();
  Vec3 inside{};
  for (const Vec3& point : soil.position) {
    index.near(point, near);
    const auto is_inside = [&](std::uint32_t k) {
      const Facet& facet = faces.facets[k];
      const FacetCoordinates at = coordinates(facet, scene.dimension, point);
      if (at.depth <= tolerance || at.depth > thickness || !at.above(facet, 0.0)) return false;
      const Vec3 foot = plus(point, at.depth, facet.normal);
      return std::none_of(near.begin(), near.end(), [&](std::uint32_t other) {
        return other != k &&
               comes_out(faces.facets[other], scene.dimension, foot, point, tolerance);
      });
    };
    const auto found = std::find_if(near.begin(), near.end(), is_inside);
    if (found == near.end() || *found >= first) continue;
    first = *found;
    inside = point;
  }
  if (first == faces.facets.size()) return;
  const Wall& wall = *faces.walls[first];
  throw SceneError(fmt::format(
      "{}'{}': the soil particle at {} lies {:.3g} m behind it. Try to reverse the order of "
      "the line's points (in 3D: the normal), or move the body or the wall.",
      message_start(scene, wall), wall.name, point_text(inside, scene.dimension),
      coordinates(faces.facets[first], scene.dimension, inside).depth));
}

}  // namespace scarp
