// SPDX-License-Identifier: BSD-3-Clause
/// Non-dominated points by one pass over the sorted run times.

#include "validation/error_time/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace scarp::validation {

std::vector<std::size_t> pareto_front(const std::vector<ErrorTime>& points) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].error) && std::isfinite(points[i].wall_s)) order.push_back(i);
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tuple(points[a].wall_s, points[a].error, a) <
           std::tuple(points[b].wall_s, points[b].error, b);
  });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : order) {
    if (!(points[i].error < least)) continue;
    least = points[i].error;
    front.push_back(i);
  }
  return front;
}

std::vector<bool> near_front(const std::vector<ErrorTime>& points, double factor) {
  constexpr double as_good = 1.05;
  const auto beats = [&](const ErrorTime& q, const ErrorTime& p) {
    return (q.wall_s * factor <= p.wall_s && q.error <= as_good * p.error) ||
           (q.error * factor <= p.error && q.wall_s <= as_good * p.wall_s);
  };
  std::vector<bool> near(points.size(), false);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const ErrorTime& p = points[i];
    near[i] =
        std::isfinite(p.error) && std::isfinite(p.wall_s) &&
        std::none_of(points.begin(), points.end(), [&](const ErrorTime& q) { return beats(q, p); });
  }
  return near;
}

}  // namespace scarp::validation
