// SPDX-License-Identifier: BSD-3-Clause
/// Chebyshev interpolation of F^n.
#include "kernels/pair/tension_factor_fit.hpp"

#include <cmath>
#include <numbers>

namespace scarp::kernels {

void fit_tension_factor(const SmoothingForm& form, double dx_over_h, double exponent,
                        double (&coefficients)[2][tension_degree + 1]) {
  constexpr int nodes = tension_degree + 1;
  const double reference = form.shape(dx_over_h);
  for (int piece = 0; piece < 2; ++piece) {
    double value[nodes], chebyshev[nodes];
    for (int k = 0; k < nodes; ++k) {
      const double t = std::cos(std::numbers::pi * (k + 0.5) / nodes);
      value[k] = std::pow(form.shape(piece + 0.5 * (t + 1.0)) / reference, exponent);
    }
    for (int m = 0; m < nodes; ++m) {
      double sum = 0.0;
      for (int k = 0; k < nodes; ++k)
        sum += value[k] * std::cos(std::numbers::pi * m * (k + 0.5) / nodes);
      chebyshev[m] = sum * (m == 0 ? 1.0 : 2.0) / nodes;
    }
    // T_m in powers of t: T_0 = 1, T_1 = t, T_{m+1} = 2 t T_m - T_{m-1}.
    double(&powers)[nodes] = coefficients[piece];
    double before[nodes] = {}, current[nodes] = {1.0};
    for (double& power : powers) power = 0.0;
    for (int m = 0; m < nodes; ++m) {
      double next[nodes] = {};
      for (int k = 0; k < nodes; ++k) {
        powers[k] += chebyshev[m] * current[k];
        next[k] = (k > 0 ? (m == 0 ? 1.0 : 2.0) * current[k - 1] : 0.0) - before[k];
      }
      for (int k = 0; k < nodes; ++k) {
        before[k] = current[k];
        current[k] = next[k];
      }
    }
  }
}

}  // namespace scarp::kernels
