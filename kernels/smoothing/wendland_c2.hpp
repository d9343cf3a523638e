// SPDX-License-Identifier: BSD-3-Clause
/// C2 smoothing function of Wendland (1995).
#pragma once

#include <numbers>

#include "kernels/smoothing/smoothing.hpp"

namespace scarp::kernels {

/// Equation: S2; (1 - q/2)^4 (2q + 1), that is 5/16 b^4 - 1/8 b^5.
inline constexpr SmoothingForm wendland_c2{"wendland_c2",
                                           {0.0, 0.3125, -0.125},
                                           0.0,
                                           7.0 / (4.0 * std::numbers::pi),
                                           21.0 / (16.0 * std::numbers::pi)};

}  // namespace scarp::kernels
