// SPDX-License-Identifier: BSD-3-Clause
/// Tensile part of a stress in closed form, which the artificial stress of one particle is made of.
#pragma once

#include <algorithm>
#include <cmath>

#include "kernels/tensor.hpp"

namespace scarp::kernels {

/// True if no principal stress is tensile (in 2D: none in the plane): all principal minors of
/// -sigma are
/// >= 0. Zero stress is in compression. Accuracy: rounding can hide a tension of 1e-8 of the
/// stress.
inline bool in_compression(const SymTensor<double>& s, int dimension) {
  const double minor_xy = s.xx * s.yy - s.xy * s.xy;
  if (s.xx > 0.0 || s.yy > 0.0 || minor_xy < 0.0) return false;
  if (dimension == 2) return true;
  const double minor_yz = s.yy * s.zz - s.yz * s.yz, minor_zx = s.zz * s.xx - s.zx * s.zx;
  const double determinant =
      s.xx * minor_yz - s.xy * (s.xy * s.zz - s.yz * s.zx) + s.zx * (s.xy * s.yz - s.yy * s.zx);
  return s.zz <= 0.0 && minor_yz >= 0.0 && minor_zx >= 0.0 && determinant <= 0.0;
}

/// Positive part of the in-plane block; zz, yz and zx of the result are 0. Equation: E27.
inline SymTensor<double> positive_part_2d(const SymTensor<double>& s) {
  const double mean = 0.5 * (s.xx + s.yy), difference = 0.5 * (s.xx - s.yy);
  const double radius = std::hypot(difference, s.xy);
  const double larger = mean + radius;
  if (larger <= 0.0) return {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  if (mean >= radius) return {s.xx, s.yy, 0.0, s.xy, 0.0, 0.0};
  // Here radius > 0: one root is positive, the other negative.
  const double half = 0.5 * larger / radius;
  return {half * (radius + difference), half * (radius - difference), 0.0, half * s.xy, 0.0, 0.0};
}

/// Positive part of a symmetric tensor without eigenvectors. Of the largest and the smallest
/// eigenvalue one is far from both others: it comes from the trigonometric form and two steps of
/// Newton, its projector P from Cayley and Hamilton. What is left lives in the plane across and is
/// split as in 2D, so that equal eigenvalues are no special case. Accuracy: 1e-12 of the largest
/// component (tested). Equation: E27.
inline SymTensor<double> positive_part_3d(const SymTensor<double>& stress) {
  const double size = std::max({std::fabs(stress.xx), std::fabs(stress.yy), std::fabs(stress.zz),
                                std::fabs(stress.xy), std::fabs(stress.yz), std::fabs(stress.zx)});
  const SymTensor<double> none{0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  if (!(size > 0.0)) return none;
  const SymTensor<double> s = (1.0 / size) * stress;
  const SymTensor<double> d = deviator(s);
  const double mean = trace(s) / 3.0;
  // Eigenvalues of d are 2 p cos(angle + 2 pi k/3), so they are at most 2 p.
  const double p = std::sqrt(contract(d, d) / 6.0);
  if (std::fabs(mean) >= 2.0 * p) return mean > 0.0 ? stress : none;
  const double i2 = -3.0 * p * p;
  const double i3 = d.xx * (d.yy * d.zz - d.yz * d.yz) - d.xy * (d.xy * d.zz - d.yz * d.zx) +
                    d.zx * (d.xy * d.yz - d.yy * d.zx);
  const double sign = i3 >= 0.0 ? 1.0 : -1.0;  // the lone eigenvalue is the largest or the smallest
  const double angle = std::acos(std::min(sign * i3 / (2.0 * p * p * p), 1.0)) / 3.0;
  double eta = 2.0 * p * sign * std::cos(angle);
  for (int k = 0; k < 2; ++k) eta -= (eta * (eta * eta + i2) - i3) / (3.0 * eta * eta + i2);
  const SymTensor<double> square{
      d.xx * d.xx + d.xy * d.xy + d.zx * d.zx, d.xy * d.xy + d.yy * d.yy + d.yz * d.yz,
      d.zx * d.zx + d.yz * d.yz + d.zz * d.zz, d.xx * d.xy + d.xy * d.yy + d.zx * d.yz,
      d.xy * d.zx + d.yy * d.yz + d.yz * d.zz, d.zx * d.xx + d.yz * d.xy + d.zz * d.zx};
  const SymTensor<double> projector =
      (1.0 / (3.0 * eta * eta + i2)) * (square + eta * d + isotropic(eta * eta + i2));
  const SymTensor<double> across = isotropic(1.0) - projector;
  // The plane across: mean -eta/2 of d, and a deviator of eigenvalues +-radius.
  const SymTensor<double> rest = d - eta * projector + (0.5 * eta) * across;
  const double radius = std::sqrt(0.5 * contract(rest, rest));
  const double centre = mean - 0.5 * eta;
  SymTensor<double> part = std::max(mean + eta, 0.0) * projector;
  if (centre >= radius) {
    part = part + centre * across + rest;
  } else if (centre > -radius) {
    part = part + (0.5 * (centre + radius) / radius) * (radius * across + rest);
  }
  return size * part;
}

/// Sum of the positive principal stresses with their directions. The artificial stress of a
/// particle is R = -epsilon / rho^2 times it. Equation: E27.
inline SymTensor<double> positive_part(const SymTensor<double>& stress, int dimension) {
  return dimension == 2 ? positive_part_2d(stress) : positive_part_3d(stress);
}

}  // namespace scarp::kernels
