// SPDX-License-Identifier: BSD-3-Clause
/// Crossings by a sweep along x.
#include "engine/scene/outline.hpp"

#include <algorithm>
#include <cmath>

namespace scarp {
namespace {

using Point = std::array<double, 2>;

constexpr std::size_t most_pairs = 50'000'000;  // about a second; 10000 points whatever their order

struct Edge {
  Point from, to;
  std::size_t index;
  double low() const { return std::min(from[0], to[0]); }
  double high() const { return std::max(from[0], to[0]); }
};

/// Twice the area of the triangle over the lengths of its sides: the sine of the angle at `a`; 0 if
/// it is no more than round-off.
double side(const Point& a, const Point& b, const Point& c) {
  const double ux = b[0] - a[0], uy = b[1] - a[1], vx = c[0] - a[0], vy = c[1] - a[1];
  const double area = ux * vy - uy * vx;
  const double scale = std::hypot(ux, uy) * std::hypot(vx, vy);
  // Differences of coordinates carry their round-off, a few 1e-16 of the coordinates.
  const double round_off = 1e-14 *
                           (std::abs(a[0]) + std::abs(a[1]) + std::abs(b[0]) + std::abs(b[1]) +
                            std::abs(c[0]) + std::abs(c[1])) *
                           (std::hypot(ux, uy) + std::hypot(vx, vy));
  return std::abs(area) <= round_off + 1e-14 * scale ? 0.0 : area;
}

std::optional<Point> crossing_of(const Edge& a, const Edge& b) {
  const double a1 = side(b.from, b.to, a.from), a2 = side(b.from, b.to, a.to);
  const double b1 = side(a.from, a.to, b.from), b2 = side(a.from, a.to, b.to);
  if (!(a1 * a2 < 0.0) || !(b1 * b2 < 0.0)) return {};
  const double share = a1 / (a1 - a2);
  return Point{a.from[0] + share * (a.to[0] - a.from[0]),
               a.from[1] + share * (a.to[1] - a.from[1])};
}

}  // namespace

std::optional<Crossing> self_crossing(const std::vector<std::array<double, 2>>& points) {
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < points.size(); ++i)
    edges.push_back({points[i], points[(i + 1) % points.size()], i});
  std::sort(edges.begin(), edges.end(),
            [](const Edge& a, const Edge& b) { return a.low() < b.low(); });
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < edges.size() && pairs < most_pairs; ++i) {
    for (std::size_t j = i + 1; j < edges.size() && edges[j].low() <= edges[i].high(); ++j) {
      ++pairs;
      const auto at = crossing_of(edges[i], edges[j]);
      if (!at) continue;
      return Crossing{std::min(edges[i].index, edges[j].index),
                      std::max(edges[i].index, edges[j].index), *at};
    }
  }
  return {};
}

}  // namespace scarp
