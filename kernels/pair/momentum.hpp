// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the momentum equation.
#pragma once

#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// Position of component (a, b) among xx, yy, zz, xy, yz, zx.
inline constexpr int tensor_index[3][3] = {{xx, xy, zx}, {xy, yy, yz}, {zx, yz, zz}};

/// Equation: E20; rho_i dv_i/dt = sigma_i . sum_j V_j grad W + sum_j V_j sigma_j . grad W: sigma_i
/// is multiplied once after the loop. 2 d^2 + d flops a pair.
template <class B, int Dim>
struct Momentum {
  B gradient_sum[Dim];
  B force[Dim];

  SCARP_INLINE Momentum() {
    unrolled<Dim>([&](auto a) SCARP_LAMBDA { gradient_sum[a] = force[a] = B(0); });
  }
  SCARP_INLINE void add(const B (&stress_j)[6], const B (&volume_gradient)[Dim]) {
    unrolled<Dim>([&](auto a) SCARP_LAMBDA {
      gradient_sum[a] = gradient_sum[a] + volume_gradient[a];
      unrolled<Dim>([&](auto b) SCARP_LAMBDA {
        force[a] = xsimd::fma(stress_j[tensor_index[a][b]], volume_gradient[b], force[a]);
      });
    });
  }
};

}  // namespace scarp::kernels
