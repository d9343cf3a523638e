// SPDX-License-Identifier: BSD-3-Clause
/// Short forms for scenes made in code: `no_slip("base", line({{0, 0}, {3, 0}}))`.
#pragma once

#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/facets.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// An angle in degrees as the scene wants it [rad].
[[nodiscard]] constexpr double degrees(double angle) { return angle * std::numbers::pi / 180.0; }

/// A body's shape from its lower to its upper corner [m].
[[nodiscard]] inline Box box(const Vec3& minimum, const Vec3& maximum) {
  return {minimum, maximum};
}

/// A body's outline; in 3D it lies in the x-z plane and is extruded over a range of y [m].
[[nodiscard]] inline Polygon polygon(std::vector<std::array<double, 2>> points,
                                     const std::array<double, 2>& extrude = {}) {
  return {std::move(points), extrude};
}

/// Faces of a 2D wall along a line, with the soil on the left of the direction of travel [m].
/// Errors: GeometryError as from `line_facets`.
[[nodiscard]] inline std::vector<Facet> line(const std::vector<std::array<double, 2>>& points) {
  return line_facets(points);
}

/// A wall that holds the soil at it.
[[nodiscard]] inline Wall no_slip(std::string name, std::vector<Facet> facets) {
  return {.name = std::move(name), .kind = WallKind::no_slip, .facets = std::move(facets)};
}

/// A wall that the soil slides along.
[[nodiscard]] inline Wall free_slip(std::string name, std::vector<Facet> facets) {
  return {.name = std::move(name), .kind = WallKind::free_slip, .facets = std::move(facets)};
}

}  // namespace scarp
