// SPDX-License-Identifier: BSD-3-Clause
/// Rotations of plane scenes.
#include "validation/cases/askew/turned.hpp"

#include <cmath>
#include <variant>

#include "engine/errors.hpp"

namespace scarp::validation {
namespace {

Vec3 rotated(const Vec3& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
}

}  // namespace

Scene turned(Scene scene, double angle) {
  if (angle == 0.0) return scene;  // walls along the axes stay so exactly
  scene.gravity = rotated(scene.gravity, angle);
  for (Body& body : scene.bodies) {
    auto* outline = std::get_if<Polygon>(&body.shape);
    if (!outline) throw Error("askew: only polygons can be turned.");
    for (auto& point : outline->points) {
      const Vec3 there = rotated({point[0], point[1], 0.0}, angle);
      point = {there[0], there[1]};
    }
  }
  for (Wall& wall : scene.walls) {
    for (Facet& facet : wall.facets) {
      for (Vec3* vector : {&facet.origin, &facet.tangent_u, &facet.normal})
        *vector = rotated(*vector, angle);
    }
  }
  for (Probe& probe : scene.probes) probe.at = rotated(probe.at, angle);
  return scene;
}

Vec3 turned_back(const Vec3& vector, double angle) { return rotated(vector, -angle); }

std::vector<TurnedBack> turned_back(const Simulation& simulation, double angle) {
  const std::vector<double> position = simulation.field("position"),
                            displacement = simulation.field("displacement"),
                            stress = simulation.field("stress");
  const double c = std::cos(angle), s = std::sin(angle);
  std::vector<TurnedBack> all(simulation.soil_count());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Vec3 u{displacement[3 * i], displacement[3 * i + 1], 0.0};
    all[i].displacement = turned_back(u, angle);
    all[i].start = turned_back({position[3 * i] - u[0], position[3 * i + 1] - u[1], 0.0}, angle);
    const double xx = stress[6 * i], yy = stress[6 * i + 1], xy = stress[6 * i + 3];
    all[i].xx = c * c * xx + s * s * yy + 2.0 * c * s * xy;
    all[i].yy = s * s * xx + c * c * yy - 2.0 * c * s * xy;
    all[i].xy = c * s * (yy - xx) + (c * c - s * s) * xy;
  }
  return all;
}

}  // namespace scarp::validation
