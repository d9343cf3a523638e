// SPDX-License-Identifier: BSD-3-Clause
/// Matrices of the oracles.
#pragma once

#include <Eigen/Dense>

#include "kernels/constitutive/stress_pass_reference.hpp"

namespace scarp::kernels {

inline Eigen::Matrix3d matrix_of(const ReferenceMatrix& a) {
  Eigen::Matrix3d m;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) m(r, c) = a[r][c];
  }
  return m;
}

inline ReferenceMatrix array_of(const Eigen::Matrix3d& m) {
  ReferenceMatrix a;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) a[r][c] = m(r, c);
  }
  return a;
}

/// Hooke's law in Lame's form and its inverse in Young's. Equation: E4, E14.
inline Eigen::Matrix3d hooke(const ReferenceModel& m, const Eigen::Matrix3d& strain) {
  const double lame = m.bulk_modulus - 2.0 / 3.0 * m.shear_modulus;
  return lame * strain.trace() * Eigen::Matrix3d::Identity() + 2.0 * m.shear_modulus * strain;
}
inline Eigen::Matrix3d strain_of(const ReferenceModel& m, const Eigen::Matrix3d& stress) {
  const double k = m.bulk_modulus, g = m.shear_modulus;
  const double young = 9.0 * k * g / (3.0 * k + g),
               poisson = (3.0 * k - 2.0 * g) / (6.0 * k + 2.0 * g);
  return ((1.0 + poisson) * stress - poisson * stress.trace() * Eigen::Matrix3d::Identity()) /
         young;
}

}  // namespace scarp::kernels
