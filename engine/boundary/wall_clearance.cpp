// SPDX-License-Identifier: BSD-3-Clause
/// Finds soil that starts inside a wall.
#include "engine/boundary/wall_clearance.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "engine/boundary/dummies.hpp"
#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/wall_surface.hpp"
#include "engine/errors.hpp"
#include "engine/particles/shapes.hpp"
#include "engine/stop.hpp"

namespace scarp {

using namespace geometry;

namespace {

/// Whether soil lies in front of the facet too, as near to it as what is seen through a wall.
bool soil_in_front(const Facet& facet, int dimension, const Particles& soil, double thickness) {
  return std::any_of(soil.position.begin(), soil.position.end(), [&](const Vec3& point) {
    const FacetCoordinates at = coordinates(facet, dimension, point);
    return at.depth < 0.0 && at.depth > -thickness && at.above(facet, 0.0);
  });
}

std::string advice(const Scene& scene, const Facet& facet, const Particles& soil,
                   double thickness) {
  if (!soil_in_front(facet, scene.dimension, soil, thickness)) {
    return "Try to reverse the order of the line's points (in 3D: the normal), or move the body or "
           "the wall.";
  }
  return fmt::format(
      "There is soil in front of it as well, but a wall has soil on one side only. Try to draw a "
      "sheet pile as a slot of {:g} m or more that the bodies leave free, with a line up its one "
      "face, over its head and down the other.",
      2.0 * scene.spacing);
}

}  // namespace

void check_wall_clearance(const Scene& scene, const Particles& soil,
                          const std::function<bool()>& stop) {
  const double tolerance = 1e-6 * scene.spacing;
  const double thickness = wall_layers(scene) * scene.spacing;
  const WallSurface surface(scene);
  FacetSearch search;
  std::size_t first = surface.faces().size();
  Vec3 inside{};
  for (const Vec3& point : soil.position) {
    stop_if_asked(stop);
    const auto near = surface.near(point, thickness, search);
    const auto is_inside = [&](std::uint32_t k) {
      const Facet& facet = surface.facet(k);
      const FacetCoordinates at = coordinates(facet, scene.dimension, point);
      if (at.depth <= tolerance || at.depth > thickness || !at.above(facet, 0.0)) return false;
      const Vec3 foot = plus(point, at.depth, facet.normal);
      return std::none_of(near.begin(), near.end(), [&](std::uint32_t other) {
        return other != k &&
               comes_out(surface.facet(other), scene.dimension, foot, point, tolerance);
      });
    };
    const auto found = std::find_if(near.begin(), near.end(), is_inside);
    if (found == near.end() || *found >= first) continue;
    first = *found;
    inside = point;
  }
  if (first == surface.faces().size()) return;
  const auto& [facet, number] = surface.faces()[first];
  const Wall& wall = scene.walls[number];
  throw SceneError(fmt::format(
      "{}'{}': the soil particle at {} lies {:.3g} m behind it. {}", message_start(scene, wall),
      wall.name, point_text(inside, scene.dimension),
      coordinates(facet, scene.dimension, inside).depth, advice(scene, facet, soil, thickness)));
}

}  // namespace scarp
