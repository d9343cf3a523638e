// SPDX-License-Identifier: BSD-3-Clause
/// Polygon, disc and ring, cut along a line.
#include "engine/particles/plane_cuts.hpp"

#include <algorithm>
#include <cmath>

namespace scarp {
namespace {

bool within(double value, double low, double high) { return value >= low && value <= high; }

}  // namespace

void cut_polygon(const std::vector<std::array<double, 2>>& points, double x, double tolerance,
                 std::vector<Range>& out) {
  std::vector<double> crossings;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [ax, ay] = points[i];
    const auto& [bx, by] = points[(i + 1) % points.size()];
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

void cut_disc(const Cylinder& disc, double x, double tolerance, std::vector<Range>& out) {
  const double away = std::abs(x - disc.centre[0]), centre = disc.centre[1];
  const auto half_chord = [&](double radius) {
    return radius > away ? std::sqrt((radius - away) * (radius + away)) : 0.0;
  };
  if (away > disc.radius + tolerance) return;
  const double outer = half_chord(disc.radius + tolerance);
  const double inner = half_chord(disc.inner_radius - tolerance);
  if (inner > 0.0) {
    out.push_back({centre - outer, centre - inner});
    out.push_back({centre + inner, centre + outer});
  } else {
    out.push_back({centre - outer, centre + outer});
  }
}

}  // namespace scarp
