// SPDX-License-Identifier: BSD-3-Clause
/// The one list of smoothing functions, in the order of scarp::SmoothingFunction.
#pragma once

#include <array>

#include "kernels/smoothing/cubic_spline.hpp"
#include "kernels/smoothing/wendland_c2.hpp"
#include "kernels/smoothing/yang_liu.hpp"

namespace scarp::kernels {

inline constexpr std::array<SmoothingForm, 3> smoothing_functions{yang_liu, cubic_spline,
                                                                  wendland_c2};

}  // namespace scarp::kernels
