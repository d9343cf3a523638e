// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the artificial stress and its weight F^n.
#pragma once

#include "kernels/pair/momentum.hpp"
#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// F^n with F = W(r)/W(dx), fitted in the truncated powers of W itself: `pow` would cost more than
/// the rest of the pair. Error over the greater of F^n and F^n(dx) = 1 (tested): 2e-7, 7e-6 and
/// 1.5e-4 for Yang & Liu, the cubic spline and Wendland C2 with n = 2.55 at h = 1.2 dx;
/// `fit_tension_factor` returns it.
template <class B, class Real>
SCARP_INLINE B tension_factor(const TruncatedPowers<B>& at, const TensionFactorView<Real>& c) {
  return xsimd::fma(polynomial(at.inner, c.inner), at.inner_squared * at.inner,
                    polynomial(at.outer, c.outer) * at.outer_squared);
}

/// Equation: E20, E27; rho_i m_j F^n (R_i + R_j) . grad W: R_j joins the stress of the neighbour,
/// and the part with R_i is multiplied once after the loop. 2 d + d (d + 1) + 2 flops a pair.
template <class B, int Dim>
struct ArtificialStress {
  B weighted_gradient_sum[Dim];  ///< sum_j F^n m_j grad W

  SCARP_INLINE ArtificialStress() {
    unrolled<Dim>([&](auto a) SCARP_LAMBDA { weighted_gradient_sum[a] = B(0); });
  }
  SCARP_INLINE void add(const PairMotion<B, Dim>& motion, const ParticleLanes<B>& i,
                        const B& factor, const B (&tension_j)[6], B (&stress_j)[6]) {
    const B weight_j = factor * i.density;
    const B weight_i = factor * motion.density;
    unrolled<Dim>([&](auto a) SCARP_LAMBDA {
      B& sum = weighted_gradient_sum[a];
      sum = xsimd::fma(weight_i, motion.volume_gradient[a], sum);
      unrolled<Dim>([&](auto b) SCARP_LAMBDA {
        if constexpr (a <= b) {
          B& stress = stress_j[tensor_index[a][b]];
          stress = xsimd::fma(weight_j, tension_j[tensor_index[a][b]], stress);
        }
      });
    });
  }
};

}  // namespace scarp::kernels
