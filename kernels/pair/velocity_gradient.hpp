// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the velocity gradient, whose symmetric and antisymmetric parts are strain and spin
/// rate.
#pragma once

#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// Equation: E23, E24; L_ab = sum_j V_j (v_j - v_i)_a d_b W. 2 d^2 flops a pair.
template <class B, int Dim>
struct VelocityGradient {
  B minus_gradient[Dim * Dim];

  SCARP_INLINE VelocityGradient() {
    unrolled<Dim * Dim>([&](auto k) SCARP_LAMBDA { minus_gradient[k] = B(0); });
  }
  SCARP_INLINE void add(const PairMotion<B, Dim>& motion) {
    unrolled<Dim>([&](auto a) SCARP_LAMBDA {
      unrolled<Dim>([&](auto b) SCARP_LAMBDA {
        B& sum = minus_gradient[a * Dim + b];
        sum = xsimd::fma(motion.velocity[a], motion.volume_gradient[b], sum);
      });
    });
  }
};

/// Equation: K1; moment_ab = sum_j V_j (x_j - x_i)_a d_b W, upper triangle row by row; the identity
/// inside a perfect, undisturbed body. d(d+1) flops a pair.
template <class B, int Dim>
struct GradientMoment {
  B minus_moment[Dim * (Dim + 1) / 2];  ///< over h

  SCARP_INLINE GradientMoment() {
    unrolled<Dim*(Dim + 1) / 2>([&](auto k) SCARP_LAMBDA { minus_moment[k] = B(0); });
  }
  SCARP_INLINE void add(const PairGeometry<B, Dim>& pair, const PairMotion<B, Dim>& motion) {
    unrolled<Dim>([&](auto a) SCARP_LAMBDA {
      unrolled<Dim - a>([&](auto ahead) SCARP_LAMBDA {
        constexpr int b = a + ahead, k = a * Dim - a * (a - 1) / 2 + ahead;
        minus_moment[k] = xsimd::fma(pair.offset[a], motion.volume_gradient[b], minus_moment[k]);
      });
    });
  }
};

}  // namespace scarp::kernels
