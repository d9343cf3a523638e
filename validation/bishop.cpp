// SPDX-License-Identifier: BSD-3-Clause
/// One circle by slices, and the search for the worst one.

#include "validation/bishop.hpp"

#include <algorithm>
#include <cmath>

#include "engine/errors.hpp"

namespace scarp::validation {
namespace {

constexpr double least_m = 0.2;  // below it Bishop's normal forces lose their meaning

struct Slice {
  double weight, width, sine, cosine;  ///< sine > 0 where the base drives the soil
};

/// Points of the lower half circle on the ground line, by x.
std::vector<double> crossings(const Slope& slope, const Circle& circle) {
  std::vector<double> found;
  for (std::size_t i = 0; i + 1 < slope.surface.size(); ++i) {
    const auto& p = slope.surface[i];
    const auto& q = slope.surface[i + 1];
    const double dx = q[0] - p[0], dy = q[1] - p[1], fx = p[0] - circle.x, fy = p[1] - circle.y;
    const double a = dx * dx + dy * dy, b = fx * dx + fy * dy;
    const double root = b * b - a * (fx * fx + fy * fy - circle.radius * circle.radius);
    if (root <= 0.0) continue;
    for (const double sign : {-1.0, 1.0}) {
      const double t = (-b + sign * std::sqrt(root)) / a;
      if (t < -1e-12 || t > 1.0 + 1e-12 || p[1] + t * dy > circle.y) continue;
      const double x = p[0] + t * dx;
      // A corner on the circle belongs to two segments.
      if (found.empty() || std::fabs(found.back() - x) > 1e-9 * circle.radius) found.push_back(x);
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Area between the circle and level 0 over x1 < x < x2.
double arc_area(const Circle& circle, double x1, double x2) {
  const auto half_disc = [&](double x) {
    const double u = std::clamp((x - circle.x) / circle.radius, -1.0, 1.0);
    return 0.5 * circle.radius * circle.radius * (u * std::sqrt(1.0 - u * u) + std::asin(u));
  };
  return circle.y * (x2 - x1) - (half_disc(x2) - half_disc(x1));
}

/// Slices from x1 to x2; `downhill` is +1 if the soil slides towards +x.
std::vector<Slice> cut(const Slope& slope, const Circle& circle, double x1, double x2, int count,
                       double downhill) {
  const auto angle = [&](double x) {
    return std::asin(std::clamp((x - circle.x) / circle.radius, -1.0, 1.0));
  };
  std::vector<double> corners{x1};  // no slice may straddle a corner of the ground line
  for (const auto& point : slope.surface) {
    if (point[0] > x1 + 1e-9 && point[0] < x2 - 1e-9) corners.push_back(point[0]);
  }
  corners.push_back(x2);
  const double step = (angle(x2) - angle(x1)) / count;
  std::vector<Slice> slices;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double from = angle(corners[i]), to = angle(corners[i + 1]);
    const int pieces = std::max(1, static_cast<int>(std::ceil((to - from) / step - 1e-9)));
    for (int k = 0; k < pieces; ++k) {
      const double a = from + (to - from) * k / pieces, b = from + (to - from) * (k + 1) / pieces;
      const double left = circle.x + circle.radius * std::sin(a);
      const double right = circle.x + circle.radius * std::sin(b), width = right - left;
      const double top = 0.5 * (surface_level(slope, left) + surface_level(slope, right)) * width;
      slices.push_back({slope.unit_weight * (top - arc_area(circle, left, right)), width,
                        -downhill * std::sin(0.5 * (a + b)), std::cos(0.5 * (a + b))});
    }
  }
  return slices;
}

std::optional<double> fixed_point(const Slope& slope, const std::vector<Slice>& slices) {
  double driving = 0.0, weight = 0.0;
  for (const Slice& s : slices) {
    driving += s.weight * s.sine;
    weight += s.weight;
  }
  if (!(driving > 1e-9 * weight) || !(weight > 0.0)) return {};
  const double tangent = std::tan(slope.friction_angle);
  double factor = 1.0;
  for (int iteration = 0; iteration < 200; ++iteration) {
    double resisting = 0.0, worst_m = 1.0;
    for (const Slice& s : slices) {
      const double m = s.cosine + s.sine * tangent / factor;
      worst_m = std::min(worst_m, m);
      resisting += (slope.cohesion * s.width + s.weight * tangent) / std::max(m, least_m);
    }
    const double next = resisting / driving;
    if (std::fabs(next - factor) <= 1e-13 * next) {
      return worst_m < least_m && tangent > 0.0 ? std::nullopt : std::optional(next);
    }
    factor = next;
  }
  return {};
}

/// The circle that leaves the chord from p to q by `depth` at its middle.
Circle through(const std::array<double, 2>& p, const std::array<double, 2>& q, double depth) {
  const double dx = q[0] - p[0], dy = q[1] - p[1], chord = std::hypot(dx, dy);
  const double radius = 0.5 * depth + chord * chord / (8.0 * depth), up = radius - depth;
  return {0.5 * (p[0] + q[0]) - up * dy / chord, 0.5 * (p[1] + q[1]) + up * dx / chord, radius};
}

/// Entry x, exit x and depth of the arc as a part of the deepest possible one.
using Trial = std::array<double, 3>;

class Search {
 public:
  Search(const Slope& slope, int slices) : slope_(slope), slices_(slices) {}

  void attempt(const Trial& trial) {
    const double left = slope_.surface.front()[0], right = slope_.surface.back()[0];
    const double x1 = std::min(trial[0], trial[1]), x2 = std::max(trial[0], trial[1]);
    if (x1 < left || x2 > right || x2 - x1 < 1e-3 * (right - left)) return;
    if (trial[2] <= 0.0 || trial[2] > 1.0) return;
    const std::array<double, 2> p{x1, surface_level(slope_, x1)}, q{x2, surface_level(slope_, x2)};
    const auto found = bishop_circle(slope_, through(p, q, trial[2] * deepest(p, q)), slices_);
    if (found && (!best_ || found->factor_of_safety < best_->factor_of_safety)) {
      best_ = found;
      trial_ = trial;
    }
  }

  const std::optional<BishopResult>& best() const { return best_; }
  const Trial& trial() const { return trial_; }

 private:
  /// Depth at which the arc touches the base, or is a half circle.
  double deepest(const std::array<double, 2>& p, const std::array<double, 2>& q) const {
    double low = 0.0, high = 0.5 * std::hypot(q[0] - p[0], q[1] - p[1]);
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      const Circle circle = through(p, q, middle);
      const double bottom =
          circle.x > p[0] && circle.x < q[0] ? circle.y - circle.radius : std::min(p[1], q[1]);
      (bottom >= slope_.base ? low : high) = middle;
    }
    return low;
  }

  const Slope& slope_;
  int slices_;
  std::optional<BishopResult> best_;
  Trial trial_{};
};

}  // namespace

double surface_level(const Slope& slope, double x) {
  const auto& line = slope.surface;
  std::size_t i = 0;
  while (i + 2 < line.size() && x > line[i + 1][0]) ++i;
  const double t = (x - line[i][0]) / (line[i + 1][0] - line[i][0]);
  return line[i][1] + t * (line[i + 1][1] - line[i][1]);
}

std::optional<BishopResult> bishop_circle(const Slope& slope, const Circle& circle, int slices) {
  const std::vector<double> ends = crossings(slope, circle);
  if (ends.size() != 2) return {};
  const double x1 = ends[0], x2 = ends[1];
  const double y1 = surface_level(slope, x1), y2 = surface_level(slope, x2);
  const double lowest =
      circle.x > x1 && circle.x < x2 ? circle.y - circle.radius : std::min(y1, y2);
  if (lowest < slope.base - 1e-9 * circle.radius) return {};
  const double downhill = y1 >= y2 ? 1.0 : -1.0;
  const auto factor = fixed_point(slope, cut(slope, circle, x1, x2, slices, downhill));
  if (!factor) return {};
  const std::array<double, 2> p{x1, y1}, q{x2, y2};
  return BishopResult{*factor, circle, downhill > 0.0 ? p : q, downhill > 0.0 ? q : p};
}

BishopResult bishop_search(const Slope& slope, int slices) {
  const double left = slope.surface.front()[0], right = slope.surface.back()[0];
  const bool high_left = slope.surface.front()[1] >= slope.surface.back()[1];
  // Corners are among the trial ends: the worst circle often leaves exactly at the toe.
  std::vector<double> ends;
  constexpr int grid = 40;
  for (int i = 0; i <= grid; ++i) ends.push_back(left + (right - left) * i / grid);
  for (const auto& point : slope.surface) ends.push_back(point[0]);
  Search search(slope, slices);
  for (const double a : ends) {
    for (const double b : ends) {
      if ((a < b) != high_left) continue;
      for (int k = 1; k <= 16; ++k) search.attempt({a, b, k / 16.0});
    }
  }
  if (!search.best()) {
    throw Error("Bishop: no circle through this ground line is valid. Try a longer ground line.");
  }
  Trial step{(right - left) / grid, (right - left) / grid, 1.0 / 16.0};
  while (step[2] > 1e-6) {
    const double before = search.best()->factor_of_safety;
    const Trial at = search.trial();
    // All 26 neighbours: the valley of constant depth runs across the axes.
    // NOLINTBEGIN(bugprone-integer-division): the digits of n to the base 3
    for (int n = 0; n < 27; ++n) {
      search.attempt({at[0] + (n % 3 - 1) * step[0], at[1] + (n / 3 % 3 - 1) * step[1],
                      at[2] + (n / 9 - 1) * step[2]});
    }
    // NOLINTEND(bugprone-integer-division)
    if (search.best()->factor_of_safety >= before) {
      for (double& s : step) s *= 0.5;
    }
  }
  return *search.best();
}

}  // namespace scarp::validation
