// SPDX-License-Identifier: BSD-3-Clause
/// Outlines in 2D, and in 3D prisms along y.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/scene/outline.hpp"
#include "engine/scene/read_parts.hpp"
#include "engine/scene/scene_problem.hpp"
#include "engine/scene/shape_list.hpp"
#include "engine/scene/text_lines.hpp"
#include "engine/scene/validate_parts.hpp"

namespace scarp {
namespace {

constexpr CompanionKey extrude_key{"extrude",
                                   "it belongs to a polygon with dimension = 3. Try without it."};

const Polygon& polygon_of(const Body::Shape& shape) { return std::get<Polygon>(shape); }

/// The outline, and in 3D the range of y over which it reaches.
Polygon extruded(std::vector<std::array<double, 2>> points, const input::Table& body,
                 int dimension) {
  Polygon polygon;
  polygon.points = std::move(points);
  if (dimension == 2) {
    if (const auto extrude = body.find(extrude_key.key))
      extrude->fail(std::string(extrude_key.misplaced));
    return polygon;
  }
  const input::Value extrude =
      body.require(extrude_key.key, "[0.0, 1.0] (range of y; the outline lies in x and z)");
  const std::vector<double> range = extrude.numbers(kernels::Unit::length, 2);
  polygon.extrude = {range[0], range[1]};
  return polygon;
}

Body::Shape read(const input::Table& body, const input::Value& value, int dimension) {
  return extruded(input::read_pairs(value, 3), body, dimension);
}

Body::Shape read_slope(const input::Table& body, const input::Value& value, int dimension) {
  return extruded(input::slope_outline(value), body, dimension);
}

void check(const Body::Shape& shape, int dimension, const std::string& path) {
  using checks::rule;
  const Polygon& polygon = polygon_of(shape);
  const std::string key = path + ".polygon";
  const auto& p = polygon.points;
  rule(p.size() >= 3, key, fmt::format("{} points", p.size()),
       "an outline needs three points. Try at least 3.");
  double area = 0.0, size = 0.0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    checks::point(p[i], fmt::format("{}[{}]", key, i));
    const auto& q = p[(i + 1) % p.size()];
    const double ax = p[i][0] - p[0][0], ay = p[i][1] - p[0][1];
    const double bx = q[0] - p[0][0], by = q[1] - p[0][1];
    area += 0.5 * (ax * by - ay * bx);
    size = std::fmax(size, std::fmax(std::abs(ax), std::abs(ay)));
  }
  rule(std::abs(area) > 1e-12 * size * size, key, fmt::format("{} points", p.size()),
       "the outline encloses no area. Try points that go round the body once.");
  if (const auto crossing = self_crossing(p)) {
    const auto edge = [&](std::size_t i) {
      const auto &a = p[i], &b = p[(i + 1) % p.size()];
      return fmt::format("[{:.9g}, {:.9g}] to [{:.9g}, {:.9g}]", a[0], a[1], b[0], b[1]);
    };
    throw SceneProblem(
        key, fmt::format("{} points", p.size()),
        fmt::format("the edges from {} and from {} cross at ({:.9g}, {:.9g}). Try points that go "
                    "round the body once, in order.",
                    edge(crossing->first), edge(crossing->second), crossing->at[0],
                    crossing->at[1]));
  }
  if (dimension != 3) return;
  checks::point(polygon.extrude, path + ".extrude");
  checks::ordered(polygon.extrude[0], polygon.extrude[1], path + ".extrude");
}

void write(const Body::Shape& shape, TextLines& lines) {
  lines.add("polygon", polygon_of(shape).points);
  lines.add("extrude", polygon_of(shape).extrude);
}

ShapeExtent extent(const Body::Shape& shape, int dimension) {
  const Polygon& polygon = polygon_of(shape);
  double low[2] = {polygon.points[0][0], polygon.points[0][1]}, high[2] = {low[0], low[1]};
  for (const auto& point : polygon.points) {
    for (std::size_t a = 0; a < 2; ++a) {
      low[a] = std::min(low[a], point[a]);
      high[a] = std::max(high[a], point[a]);
    }
  }
  if (dimension == 2) return {{low[0], low[1], 0.0}, {high[0], high[1], 0.0}};
  return {{low[0], polygon.extrude[0], low[1]}, {high[0], polygon.extrude[1], high[1]}};
}

std::string describe(const Body::Shape& shape, int dimension) {
  return from_to("polygon", extent(shape, dimension), dimension);
}

/// Ranges inside the outline along its axis `along`, at `x` on the other one. Parity of crossings
/// decides the inside; every edge adds the points that lie on it to `tolerance`.
void cut_outline(const std::vector<std::array<double, 2>>& points, std::size_t along, double x,
                 double tolerance, std::vector<Range>& out) {
  const std::size_t across = 1 - along;
  std::vector<double> crossings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &a = points[i], &b = points[(i + 1) % points.size()];
    const double ax = a[across], ay = a[along], bx = b[across], by = b[along];
    const auto [left, right] = std::minmax(ax, bx);
    if (!within(x, left - tolerance, right + tolerance)) continue;
    const auto [low, high] = std::minmax(ay, by);
    const double run = bx - ax, rise = by - ay;
    if (std::abs(run) <= tolerance) {
      out.push_back({low, high});
    } else {
      const double y = ay + std::clamp((x - ax) / run, 0.0, 1.0) * rise;
      const double reach = tolerance * std::hypot(run, rise) / std::abs(run);
      out.push_back({std::max(y - reach, low), std::min(y + reach, high)});
    }
    if ((ax > x) != (bx > x)) crossings.push_back(ay + (x - ax) / run * rise);
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t k = 1; k < crossings.size(); k += 2) {
    out.push_back({crossings[k - 1], crossings[k]});
  }
}

ShapeCut cut(const Body::Shape& shape, int dimension, double tolerance, const std::string&) {
  const std::size_t up = dimension == 2 ? 1 : 2;
  return [p = &polygon_of(shape), up, tolerance](std::size_t axis, const Vec3& at,
                                                 std::vector<Range>& out) {
    if (axis == up) return cut_outline(p->points, 1, at[0], tolerance, out);
    if (axis == 0) return cut_outline(p->points, 0, at[up], tolerance, out);
    std::vector<Range> heights;
    cut_outline(p->points, 1, at[0], tolerance, heights);
    const bool inside = std::any_of(heights.begin(), heights.end(), [&](const Range& range) {
      return within(at[2], range.low, range.high);
    });
    if (inside) out.push_back({p->extrude[0], p->extrude[1]});
  };
}

/// Heights of the sites at `x`, each looked up a tolerance to the left. A site within a tolerance
/// of an edge is below what stands here for that edge, whichever way it slants.
void site_heights(const std::vector<std::array<double, 2>>& points, double x, double tolerance,
                  std::vector<Range>& out) {
  const double left = x - tolerance;
  std::vector<double> crossings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    // From left to right, so that two outlines which share an edge cross it at the same number.
    const auto& [a, b] = std::minmax(points[i], points[(i + 1) % points.size()]);
    if ((a[0] < left) == (b[0] < left)) continue;
    const double slope = (b[1] - a[1]) / (b[0] - a[0]);
    // What a tolerance across the edge and one to the left come to upwards, less the one that every
    // range has.
    const double raise = tolerance * (std::hypot(1.0, slope) + std::abs(slope) - 1.0);
    crossings.push_back(std::min(a[1] + (left - a[0]) * slope + raise, std::max(a[1], b[1])));
  }
  std::sort(crossings.begin(), crossings.end());
  for (std::size_t k = 1; k < crossings.size(); k += 2)
    out.push_back({crossings[k - 1], crossings[k]});
}

ShapeCut sites(const Body::Shape& shape, double tolerance) {
  return [p = &polygon_of(shape), tolerance](std::size_t, const Vec3& at, std::vector<Range>& out) {
    site_heights(p->points, at[0], tolerance, out);
  };
}

void corners(const Body::Shape& shape, int dimension, std::size_t axis, std::vector<double>& out) {
  const Polygon& polygon = polygon_of(shape);
  if (dimension == 3 && axis == 1) {
    out.insert(out.end(), polygon.extrude.begin(), polygon.extrude.end());
    return;
  }
  for (const auto& point : polygon.points) out.push_back(point[axis == 0 ? 0 : 1]);
}

double cost(const Body::Shape& shape) {
  return static_cast<double>(polygon_of(shape).points.size());
}

}  // namespace

const ShapeRow polygon_row{"polygon",
                           extrude_key,
                           read,
                           check,
                           write,
                           describe,
                           extent,
                           cut,
                           false,
                           false,
                           corners,
                           cost,
                           {"slope", read_slope},
                           sites};

}  // namespace scarp
