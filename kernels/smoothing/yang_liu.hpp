// SPDX-License-Identifier: BSD-3-Clause
/// Smoothing function of Yang & Liu (2012).
#pragma once

#include <numbers>

#include "kernels/smoothing/smoothing.hpp"

namespace scarp::kernels {

/// Equation: E25; q^3 - 6q + 6 for q < 1, (2-q)^3 for 1 <= q < 2, that is b^3 - 2 a^3.
inline constexpr SmoothingForm yang_liu{"yang_liu",
                                        {1.0, 0.0, 0.0},
                                        -2.0,
                                        1.0 / (3.0 * std::numbers::pi),
                                        15.0 / (62.0 * std::numbers::pi)};

}  // namespace scarp::kernels
