// SPDX-License-Identifier: BSD-3-Clause
/// Bishop's simplified method for a dry, homogeneous slope: the oracle of the factor of safety.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace scarp::validation {

/// A slope in plane strain; either end may be the high one.
struct Slope {
  std::vector<std::array<double, 2>> surface;  ///< ground line, x increasing [m]
  double base = 0.0;                           ///< level of the firm base [m]
  double unit_weight = 0.0;                    ///< [N/m3]
  double cohesion = 0.0;                       ///< [Pa]
  double friction_angle = 0.0;                 ///< [rad]
};

struct Circle {
  double x = 0.0, y = 0.0, radius = 0.0;  ///< [m]
};

struct BishopResult {
  double factor_of_safety = 0.0;
  Circle circle;
  std::array<double, 2> entry{};  ///< where the circle meets the ground, upper end [m]
  std::array<double, 2> exit{};   ///< ... and lower end [m]
};

/// Factor of safety of the soil above one circle, cut into at least `slices` slices of equal angle.
/// Source: Bishop 1955, F = sum((c b + W tan phi)/m) / sum(W sin a), m = cos a + sin a tan phi / F,
/// by fixed-point iteration. Empty for a circle that does not cut the ground line in exactly two
/// points, reaches below the base or beyond the ends of the ground line, would not slide, or has
/// m below 0.2 in a slice (the method's own limit of validity).
std::optional<BishopResult> bishop_circle(const Slope& slope, const Circle& circle,
                                          int slices = 50);

/// The least factor of safety over all circles: a grid over entry, exit and depth (exits at, above
/// and beyond the toe; depths down to a circle tangent to the base), then refined. Errors: Error
/// if no circle is valid.
BishopResult bishop_search(const Slope& slope, int slices = 50);

/// Level of the ground line at x [m].
double surface_level(const Slope& slope, double x);

}  // namespace scarp::validation
