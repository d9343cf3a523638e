// SPDX-License-Identifier: BSD-3-Clause
/// Form shared by all smoothing functions: truncated powers, so that one sweep serves them all.
#pragma once

namespace scarp::kernels {

/// W(q) = alpha_D/h^d [ b^3 (value[0] + b (value[1] + b value[2])) + value_inner a^3 ], b =
/// max(2-q, 0), a = max(1-q, 0), q = r/h. No branches: both powers vanish outside their support.
struct SmoothingForm {
  const char* name;
  double value[3];
  double value_inner;
  double normalisation_2d;  ///< alpha_D of 2D, h = 1
  double normalisation_3d;  ///< alpha_D of 3D, h = 1

  constexpr double normalisation(int dimension) const {
    return dimension == 2 ? normalisation_2d : normalisation_3d;
  }
  /// Coefficients of dW/dq in b^2, b^3, b^4 (0..2) and a^2 (3).
  constexpr double derivative(int k) const {
    return k == 3 ? -3.0 * value_inner : -(3.0 + k) * value[k];
  }
  /// W at q without its normalisation.
  constexpr double shape(double q) const {
    const double b = q < 2.0 ? 2.0 - q : 0.0, a = q < 1.0 ? 1.0 - q : 0.0;
    return b * b * b * (value[0] + b * (value[1] + b * value[2])) + value_inner * a * a * a;
  }
  /// dW/dq at q without its normalisation.
  constexpr double slope(double q) const {
    const double b = q < 2.0 ? 2.0 - q : 0.0, a = q < 1.0 ? 1.0 - q : 0.0;
    return b * b * (derivative(0) + b * (derivative(1) + b * derivative(2))) +
           derivative(3) * a * a;
  }
};

}  // namespace scarp::kernels
