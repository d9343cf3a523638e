// SPDX-License-Identifier: BSD-3-Clause
/// Polynomials for the weight F^n of the artificial stress, fitted once per run.
#pragma once

#include "kernels/particle_view.hpp"
#include "kernels/smoothing/smoothing.hpp"

namespace scarp {

struct TensionFactorFit {
  kernels::TensionFactorView<double> factor;
  double error;  ///< largest difference from F^n over the greater of F^n and F^n(dx) = 1
};

/// F^n, F = W(q)/W(dx), as `tension_factor` evaluates it: least squares of the error as defined
/// above. Equation: E27. Accuracy (tested): 2e-7 for Yang & Liu with n = 2.55 at h = 1.2 dx; 0.6 %
/// and better for every function with n from 1 to 4 at h >= dx. Pre: 0 < dx_over_h < 2, exponent >
/// 0.
TensionFactorFit fit_tension_factor(const kernels::SmoothingForm& form, double dx_over_h,
                                    double exponent);

}  // namespace scarp
