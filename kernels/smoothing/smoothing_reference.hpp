// SPDX-License-Identifier: BSD-3-Clause
/// Smoothing functions as the literature prints them, piece by piece: the oracle of the truncated
/// powers.
#pragma once

#include <numbers>

namespace scarp::kernels {

/// In the order of `smoothing_functions`.
enum class ReferenceSmoothing { yang_liu, cubic_spline, wendland_c2 };

/// W(r, h) [1/m2 in 2D, 1/m3 in 3D]. Equation: E25, S1, S2.
inline double smoothing_value_reference(ReferenceSmoothing which, int dimension, double r,
                                        double h) {
  const double pi = std::numbers::pi, q = r / h;
  const double volume = dimension == 2 ? h * h : h * h * h;
  if (q >= 2.0) return 0.0;
  switch (which) {
    case ReferenceSmoothing::yang_liu: {
      const double alpha = (dimension == 2 ? 1.0 / (3.0 * pi) : 15.0 / (62.0 * pi)) / volume;
      return alpha * (q < 1.0 ? q * q * q - 6.0 * q + 6.0 : (2.0 - q) * (2.0 - q) * (2.0 - q));
    }
    case ReferenceSmoothing::cubic_spline: {
      const double alpha = (dimension == 2 ? 10.0 / (7.0 * pi) : 1.0 / pi) / volume;
      return alpha * (q < 1.0 ? 1.0 - 1.5 * q * q + 0.75 * q * q * q
                              : 0.25 * (2.0 - q) * (2.0 - q) * (2.0 - q));
    }
    case ReferenceSmoothing::wendland_c2:
      break;
  }
  const double alpha = (dimension == 2 ? 7.0 / (4.0 * pi) : 21.0 / (16.0 * pi)) / volume;
  const double half = 1.0 - 0.5 * q;
  return alpha * half * half * half * half * (2.0 * q + 1.0);
}

/// dW/dr [1/m3 in 2D, 1/m4 in 3D], the derivative of each piece. Equation: E25, S1, S2.
inline double smoothing_slope_reference(ReferenceSmoothing which, int dimension, double r,
                                        double h) {
  const double pi = std::numbers::pi, q = r / h;
  const double volume = dimension == 2 ? h * h : h * h * h;
  if (q >= 2.0) return 0.0;
  switch (which) {
    case ReferenceSmoothing::yang_liu: {
      const double alpha = (dimension == 2 ? 1.0 / (3.0 * pi) : 15.0 / (62.0 * pi)) / volume;
      return alpha / h * (q < 1.0 ? 3.0 * q * q - 6.0 : -3.0 * (2.0 - q) * (2.0 - q));
    }
    case ReferenceSmoothing::cubic_spline: {
      const double alpha = (dimension == 2 ? 10.0 / (7.0 * pi) : 1.0 / pi) / volume;
      return alpha / h * (q < 1.0 ? -3.0 * q + 2.25 * q * q : -0.75 * (2.0 - q) * (2.0 - q));
    }
    case ReferenceSmoothing::wendland_c2:
      break;
  }
  const double alpha = (dimension == 2 ? 7.0 / (4.0 * pi) : 21.0 / (16.0 * pi)) / volume;
  const double half = 1.0 - 0.5 * q;
  return alpha / h * (-5.0 * q * half * half * half);
}

}  // namespace scarp::kernels
