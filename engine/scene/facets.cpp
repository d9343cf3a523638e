// SPDX-License-Identifier: BSD-3-Clause
/// Geometry of the wall shapes.
#include "engine/scene/facets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/scene/vector.hpp"

namespace scarp {
namespace {

using geometry::cross;
using geometry::dot;

double length(const Vec3& a) { return std::hypot(a[0], a[1], a[2]); }
Vec3 unit(const Vec3& a) {
  const double l = length(a);
  return {a[0] / l, a[1] / l, a[2] / l};
}

Facet segment(const Vec3& from, const Vec3& to) {
  const Vec3 along{to[0] - from[0], to[1] - from[1], 0.0};
  if (!(length(along) > 0.0)) throw GeometryError("a segment has no length. Try distinct points");
  const Vec3 u = unit(along);
  return {from, u, {0.0, 0.0, 1.0}, length(along), 0.0, {-u[1], u[0], 0.0}};
}

}  // namespace

std::vector<Facet> line_facets(const std::vector<std::array<double, 2>>& points) {
  if (points.size() < 2) throw GeometryError("a line needs two points. Try [[0, 0], [1, 0]]");
  std::vector<Facet> facets;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto& a = points[i - 1];
    const auto& b = points[i];
    facets.push_back(segment({a[0], a[1], 0.0}, {b[0], b[1], 0.0}));
  }
  return facets;
}

Facet rectangle_facet(const Vec3& origin, const Vec3& u, const Vec3& v) {
  const double length_u = length(u), length_v = length(v);
  if (!(length_u > 0.0 && length_v > 0.0)) {
    throw GeometryError("an edge vector has no length. Try u = [1, 0, 0], v = [0, 1, 0]");
  }
  if (std::abs(dot(unit(u), unit(v))) > 1e-6) {
    throw GeometryError("u and v are not at right angles. Try edges with u . v = 0");
  }
  return {origin, unit(u), unit(v), length_u, length_v, unit(cross(u, v))};
}

Facet plane_facet(const Vec3& point, const Vec3& normal, double size, int dimension) {
  if (!(length(normal) > 0.0)) throw GeometryError("the normal has no length. Try [0, 0, 1]");
  if (!(size > 0.0)) throw GeometryError("the size is not positive. Try a length above 0");
  const Vec3 n = unit(normal);
  const double half = 0.5 * size;
  if (dimension == 2) {
    const Vec3 u{n[1], -n[0], 0.0};  // the normal is on its left
    return segment({point[0] - half * u[0], point[1] - half * u[1], 0.0},
                   {point[0] + half * u[0], point[1] + half * u[1], 0.0});
  }
  // Crossing the normal with the axis least along it keeps patches of axis-aligned planes
  // axis-aligned.
  const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
  Vec3 axis{};
  axis[static_cast<std::size_t>(std::min_element(n.begin(), n.end(), less) - n.begin())] = 1.0;
  const Vec3 u = unit(cross(axis, n)), v = cross(n, u);
  Vec3 origin{};
  for (std::size_t d = 0; d < 3; ++d) origin[d] = point[d] - half * (u[d] + v[d]);
  return {origin, u, v, size, size, n};
}

std::vector<Facet> box_facets(const Box& box, const std::vector<std::string>& open, int dimension) {
  const std::vector<std::string> all = {"-x", "+x", "-y", "+y", "-z", "+z"};
  const std::vector<std::string> names(all.begin(), all.begin() + 2 * dimension);
  for (const std::string& face : open) {
    if (std::find(names.begin(), names.end(), face) == names.end()) {
      throw GeometryError(
          fmt::format("there is no face '{}'. Try {}", face, fmt::join(names, ", ")));
    }
  }
  const auto& [x0, y0, z0] = box.minimum;
  const auto& [x1, y1, z1] = box.maximum;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
    if (!(box.maximum[d] > box.minimum[d])) {
      throw GeometryError(
          "max is not above min in every direction. Try min = [0, 0], max = [1, 1]");
    }
  }
  const double a = x1 - x0, b = y1 - y0, c = z1 - z0;
  std::vector<Facet> faces;
  if (dimension == 2) {
    faces = {segment({x0, y1, 0}, {x0, y0, 0}), segment({x1, y0, 0}, {x1, y1, 0}),
             segment({x0, y0, 0}, {x1, y0, 0}), segment({x1, y1, 0}, {x0, y1, 0})};
  } else {
    faces = {rectangle_facet({x0, y0, z0}, {0, b, 0}, {0, 0, c}),
             rectangle_facet({x1, y0, z0}, {0, 0, c}, {0, b, 0}),
             rectangle_facet({x0, y0, z0}, {0, 0, c}, {a, 0, 0}),
             rectangle_facet({x0, y1, z0}, {a, 0, 0}, {0, 0, c}),
             rectangle_facet({x0, y0, z0}, {a, 0, 0}, {0, b, 0}),
             rectangle_facet({x0, y0, z1}, {0, b, 0}, {a, 0, 0})};
  }
  std::vector<Facet> closed;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (std::find(open.begin(), open.end(), names[f]) == open.end()) closed.push_back(faces[f]);
  }
  if (closed.empty()) throw GeometryError("every face is open. Try to leave one closed");
  return closed;
}

}  // namespace scarp
