// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the continuity equation.
#pragma once

#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// Equation: E19; d rho_i/dt = sum_j m_j (v_i - v_j) . grad_i W. 3 flops a pair.
template <class B>
struct Continuity {
  B density_rate = B(0);

  template <int Dim>
  SCARP_INLINE void add(const PairGeometry<B, Dim>& pair, const PairMotion<B, Dim>& motion) {
    density_rate = xsimd::fma(motion.density * pair.gradient, motion.approach, density_rate);
  }
};

}  // namespace scarp::kernels
