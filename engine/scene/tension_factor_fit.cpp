// SPDX-License-Identifier: BSD-3-Clause
/// Least-squares fit of F^n in truncated powers.
#include "engine/scene/tension_factor_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <Eigen/Dense>

namespace scarp {
namespace {

constexpr int outer_count = std::size(kernels::TensionFactorView<double>{}.outer);
constexpr int inner_count = std::size(kernels::TensionFactorView<double>{}.inner);

/// Points that crowd towards the ends of [0, 1] and [1, 2], where polynomials err most.
Eigen::VectorXd chebyshev_points(int per_piece) {
  Eigen::VectorXd q(2 * per_piece);
  for (int k = 0; k < per_piece; ++k) {
    q[k] = 0.5 + 0.5 * std::cos(std::numbers::pi * (k + 0.5) / per_piece);
    q[per_piece + k] = 1.0 + q[k];
  }
  return q;
}

}  // namespace

TensionFactorFit fit_tension_factor(const kernels::SmoothingForm& form, double dx_over_h,
                                    double exponent) {
  // Four times the unknowns on each piece: errors between points are those at points to a few per
  // cent.
  const Eigen::VectorXd q = chebyshev_points(4 * (outer_count + inner_count));
  const double reference = form.shape(dx_over_h);
  Eigen::MatrixXd terms(q.size(), outer_count + inner_count);
  Eigen::VectorXd wanted(q.size());
  for (Eigen::Index row = 0; row < q.size(); ++row) {
    const double b = 2.0 - q[row], a = std::max(1.0 - q[row], 0.0);
    const double factor = std::pow(form.shape(q[row]) / reference, exponent);
    const double weight = 1.0 / std::max(1.0, factor);
    for (int k = 0; k < outer_count; ++k) terms(row, k) = weight * std::pow(b, 2 + k);
    for (int k = 0; k < inner_count; ++k) terms(row, outer_count + k) = weight * std::pow(a, 3 + k);
    wanted[row] = weight * factor;
  }
  const Eigen::VectorXd solution = terms.colPivHouseholderQr().solve(wanted);
  TensionFactorFit fit{};
  std::copy_n(solution.begin(), outer_count, fit.factor.outer);
  std::copy_n(solution.begin() + outer_count, inner_count, fit.factor.inner);
  fit.error = (terms * solution - wanted).cwiseAbs().maxCoeff();
  return fit;
}

}  // namespace scarp
