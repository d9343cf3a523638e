// SPDX-License-Identifier: BSD-3-Clause
/// Finds soil that starts inside a wall.
#include "engine/boundary/wall_clearance.hpp"

#include <fmt/format.h>

#include "engine/boundary/dummies.hpp"
#include "engine/boundary/facet_geometry.hpp"
#include "engine/errors.hpp"
#include "engine/particles/shapes.hpp"

namespace scarp {

using namespace geometry;

namespace {

bool behind_another_face(const Scene& scene, const Facet& facet, const Vec3& foot,
                         const Vec3& point, double tolerance) {
  for (const Wall& wall : scene.walls) {
    for (const Facet& other : wall.facets) {
      if (&other == &facet) continue;
      if (comes_out(other, scene.dimension, foot, point, tolerance)) return true;
    }
  }
  return false;
}

}  // namespace

void check_wall_clearance(const Scene& scene, const SoilPoints& soil) {
  const double tolerance = 1e-6 * scene.spacing;
  const double thickness = wall_layers(scene) * scene.spacing;
  for (const Wall& wall : scene.walls) {
    for (const Facet& facet : wall.facets) {
      for (const Vec3& point : soil.position) {
        const FacetCoordinates at = coordinates(facet, scene.dimension, point);
        if (at.depth <= tolerance || at.depth > thickness) continue;
        if (!at.above(facet, 0.0)) continue;
        const Vec3 foot = plus(point, at.depth, facet.normal);
        if (behind_another_face(scene, facet, foot, point, tolerance)) continue;
        throw SceneError(fmt::format(
            "{}'{}': the soil particle at {} lies {:.3g} m behind it. Try to reverse the order of "
            "the line's points (in 3D: the normal), or move the body or the wall.",
            message_start(scene, wall), wall.name, point_text(point, scene.dimension), at.depth));
      }
    }
  }
}

}  // namespace scarp
