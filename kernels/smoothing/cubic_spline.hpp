// SPDX-License-Identifier: BSD-3-Clause
/// Cubic B-spline smoothing function (Monaghan & Lattanzio 1985).
#pragma once

#include <numbers>

#include "kernels/smoothing/smoothing.hpp"

namespace scarp::kernels {

/// Equation: S1; 1 - 1.5 q^2 + 0.75 q^3 for q < 1, (2-q)^3/4 for 1 <= q < 2, that is (b^3 - 4
/// a^3)/4.
inline constexpr SmoothingForm cubic_spline{"cubic_spline",
                                            {0.25, 0.0, 0.0},
                                            -1.0,
                                            10.0 / (7.0 * std::numbers::pi),
                                            1.0 / std::numbers::pi};

}  // namespace scarp::kernels
