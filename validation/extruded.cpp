// SPDX-License-Identifier: BSD-3-Clause
/// Extrusion of boxes and walls.

#include "validation/extruded.hpp"

#include <algorithm>
#include <limits>

#include "engine/errors.hpp"
#include "engine/scene/facets.hpp"

namespace scarp::validation {

Scene extruded(Scene plane, double depth) {
  Scene scene = std::move(plane);
  scene.dimension = 3;
  for (Body& body : scene.bodies) {
    Box* box = std::get_if<Box>(&body.shape);
    if (box == nullptr) throw Error("only boxes are extruded: give the body as a box");
    box->minimum[2] = 0.0;
    box->maximum[2] = depth;
    if (!body.velocity_field.empty()) body.velocity_field.resize(3, "0");
  }
  Vec3 low{}, high{};
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (Wall& wall : scene.walls) {
    for (Facet& facet : wall.facets) {
      for (std::size_t a = 0; a < 2; ++a) {
        const double end = facet.origin[a] + facet.length_u * facet.tangent_u[a];
        low[a] = std::min({low[a], facet.origin[a], end});
        high[a] = std::max({high[a], facet.origin[a], end});
      }
      // z x u is the left side of u, where the soil of a 2D wall lies.
      facet = {facet.origin, {0, 0, 1}, facet.tangent_u, depth, facet.length_u, facet.normal};
    }
  }
  if (scene.walls.empty()) return scene;
  const Vec3 along_x{high[0] - low[0], 0, 0}, along_y{0, high[1] - low[1], 0};
  Wall ends;
  ends.name = "ends in z";
  ends.kind = WallKind::free_slip;
  ends.facets = {rectangle_facet({low[0], low[1], 0}, along_x, along_y),
                 rectangle_facet({low[0], low[1], depth}, along_y, along_x)};
  scene.walls.push_back(ends);
  return scene;
}

}  // namespace scarp::validation
