// SPDX-License-Identifier: BSD-3-Clause
/// Polynomials for the weight F^n of the artificial stress, fitted once per run.
#pragma once

#include "kernels/particle_view.hpp"
#include "kernels/smoothing/smoothing.hpp"

namespace scarp::kernels {

/// Coefficients of F^n, F = W(q)/W(dx), in powers of t = 2q-1 on [0, 1) and t = 2q-3 on [1, 2], as
/// `tension_factors` evaluates them: Chebyshev interpolation on each piece. Equation: E27.
/// Pre: 0 < dx_over_h < 2, exponent > 0.
void fit_tension_factor(const SmoothingForm& form, double dx_over_h, double exponent,
                        double (&coefficients)[2][tension_degree + 1]);

}  // namespace scarp::kernels
