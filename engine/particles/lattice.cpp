// SPDX-License-Identifier: BSD-3-Clause
/// Compares mass and centre of the first body with those of its particles.
#include "engine/particles/lattice.hpp"

#include <array>
#include <limits>
#include <variant>
#include <vector>

namespace scarp {
namespace {

using Point = std::array<double, 2>;

struct Outline {
  double area = 0.0, length = 0.0;
  Point centre{};
};

Outline outline_of(const std::vector<Point>& points) {
  Outline outline;
  const Point& start = points[0];  // near the outline, so that little cancels
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point &p = points[i], &q = points[(i + 1) % points.size()];
    const Point a{p[0] - start[0], p[1] - start[1]}, b{q[0] - start[0], q[1] - start[1]};
    const double twice = a[0] * b[1] - a[1] * b[0];
    outline.area += 0.5 * twice;
    for (std::size_t k = 0; k < 2; ++k) outline.centre[k] += twice * (a[k] + b[k]) / 6.0;
    outline.length += std::hypot(b[0] - a[0], b[1] - a[1]);
  }
  for (std::size_t k = 0; k < 2; ++k)
    outline.centre[k] = start[k] + outline.centre[k] / outline.area;
  outline.area = std::abs(outline.area);
  return outline;
}

/// Whether an edge lies along an axis, to be met by the lattice.
bool is_along_an_axis(const std::vector<Point>& points, double tolerance) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point &p = points[i], &q = points[(i + 1) % points.size()];
    for (std::size_t a = 0; a < 2; ++a) {
      if (std::abs(q[a] - p[a]) <= tolerance) return true;
    }
  }
  return false;
}

/// By how many spacings the outline is off all around, |n dx^2 - A|/(P dx) of its area and
/// |centre of the particles - centre|/dx, for P its length.
double off(const Outline& outline, const ColumnShape& shape, const Lattice& lattice) {
  const double dx = lattice.spacing;
  std::vector<Range> ranges;
  double count = 0.0;
  Point sum{};
  const Sites columns = lattice.inside(shape, 0, shape.minimum[0], shape.maximum[0]);
  for (std::int64_t i = columns.first; i <= columns.last; ++i) {
    const double x = lattice.at(0, i);
    ranges.clear();
    shape.sites(shape.up, {x, 0.0, 0.0}, ranges);
    for (const Range& range : ranges) {
      const Sites sites = lattice.inside(shape, shape.up, range.low, range.high);
      const auto held = static_cast<double>(sites.count());
      if (held == 0.0) continue;
      count += held;
      sum[0] += held * x;
      sum[1] += 0.5 * held * (lattice.at(shape.up, sites.first) + lattice.at(shape.up, sites.last));
    }
  }
  if (count == 0.0) return std::numeric_limits<double>::infinity();
  return std::abs(count * dx * dx - outline.area) / (outline.length * dx) +
         std::hypot(sum[0] / count - outline.centre[0], sum[1] / count - outline.centre[1]) / dx;
}

}  // namespace

Lattice lattice_of(const Scene& scene, const ColumnShape& first) {
  constexpr double enough = 0.25;
  constexpr int steps = 8;
  constexpr double most_columns = 20000.0;  // of so many a row is nothing
  const Lattice anchored{first.minimum, scene.spacing};
  const auto* polygon = std::get_if<Polygon>(&scene.bodies[0].shape);
  if (polygon == nullptr) return anchored;
  if (is_along_an_axis(polygon->points, first.tolerance)) return anchored;
  if (first.maximum[0] - first.minimum[0] > most_columns * scene.spacing) return anchored;
  const Outline outline = outline_of(polygon->points);
  double least = off(outline, first, anchored);
  if (least <= enough) return anchored;
  Lattice best = anchored;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      Lattice moved = anchored;
      moved.origin[0] += scene.spacing * i / steps;
      moved.origin[first.up] += scene.spacing * j / steps;
      // Places that differ by rounding are the same: the first of them is taken.
      const double here = off(outline, first, moved);
      if (here >= least - 1e-9) continue;
      least = here;
      best = moved;
    }
  }
  return best;
}

}  // namespace scarp
