// SPDX-License-Identifier: BSD-3-Clause
/// Size and shape of a set of particles in a section.
#pragma once

#include <array>
#include <vector>

namespace scarp::validation {

class PlaneZone {
 public:
  /// A particle at `place` [m] that stands for `area` [m2].
  void add(const std::array<double, 2>& place, double area);

  double area() const { return area_; }   ///< of all particles [m2]
  double extent(std::size_t axis) const;  ///< between the farthest centres [m]; 0 if empty
  /// Area of the convex hull of the centres over that of the rectangle that holds them: 1/2 for a
  /// triangle on the rectangle's edge, 2/3 for a parabola, 1 for a rectangle. NaN for fewer than 3.
  double hull_share() const;

 private:
  std::vector<std::array<double, 2>> places_;
  double area_ = 0.0;
};

}  // namespace scarp::validation
