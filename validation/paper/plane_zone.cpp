// SPDX-License-Identifier: BSD-3-Clause
/// Convex hull by Andrew's monotone chain.

#include "validation/paper/plane_zone.hpp"

#include <algorithm>
#include <cmath>

namespace scarp::validation {
namespace {

using Point = std::array<double, 2>;

double cross(const Point& o, const Point& a, const Point& b) {
  return (a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]);
}

std::vector<Point> convex_hull(std::vector<Point> points) {
  std::sort(points.begin(), points.end());
  std::vector<Point> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const Point& point : points) {
      while (hull.size() >= first + 2 &&
             cross(hull[hull.size() - 2], hull[hull.size() - 1], point) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(point);
    }
    hull.pop_back();  // begins the other side
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double area_inside(const std::vector<Point>& outline) {
  double twice = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    twice += cross({0.0, 0.0}, outline[k], outline[(k + 1) % outline.size()]);
  }
  return 0.5 * std::fabs(twice);
}

}  // namespace

void PlaneZone::add(const Point& place, double area) {
  places_.push_back(place);
  area_ += area;
}

double PlaneZone::extent(std::size_t axis) const {
  const auto [low, high] =
      std::minmax_element(places_.begin(), places_.end(),
                          [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
  return places_.empty() ? 0.0 : (*high)[axis] - (*low)[axis];
}

double PlaneZone::hull_share() const {
  if (places_.size() < 3) return std::nan("");
  return area_inside(convex_hull(places_)) / (extent(0) * extent(1));
}

}  // namespace scarp::validation
