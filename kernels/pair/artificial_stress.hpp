// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the artificial stress and its weight F^n.
#pragma once

#include "kernels/pair/momentum.hpp"
#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// F^n with F = W(r)/W(dx) as a Chebyshev fit in q, one polynomial on each side of q = 1: `pow`
/// would cost more than the rest of the pair. Takes q and leaves F^n; the vectors of a block go
/// through the polynomial together, so that they share its coefficients and hide its latency.
/// Accuracy (tested): 1e-5 of F^n(0) for n up to 4; for n = 2.55 1e-8, 1e-7 and 1e-5 of F^n(dx) for
/// Yang & Liu, the cubic spline and Wendland C2.
template <class B, class Real, std::size_t Count>
SCARP_INLINE void tension_factors(B (&q)[Count],
                                  const Real (&coefficients)[2][tension_degree + 1]) {
  B t[Count];
  typename B::batch_bool_type inner[Count];
  const auto coefficient = [&](std::size_t v, int k) SCARP_LAMBDA {
    return xsimd::select(inner[v], B(coefficients[0][k]), B(coefficients[1][k]));
  };
  unrolled<Count>([&](auto v) SCARP_LAMBDA {
    inner[v] = q[v] < B(Real(1));
    t[v] = xsimd::fma(B(Real(2)), xsimd::min(q[v], B(Real(2))),
                      xsimd::select(inner[v], B(Real(-1)), B(Real(-3))));
    q[v] = coefficient(v, tension_degree);
  });
  for (int k = tension_degree - 1; k >= 0; --k) {
    unrolled<Count>([&](auto v) SCARP_LAMBDA { q[v] = xsimd::fma(q[v], t[v], coefficient(v, k)); });
  }
}

/// Equation: E20, E27; rho_i m_j F^n (R_i + R_j) . grad W: R_j joins the stress of the neighbour,
/// and the part with R_i is multiplied once after the loop. 2 d + d (d + 1) + 2 flops a pair.
template <class B, int Dim>
struct ArtificialStress {
  B weighted_gradient_sum[Dim];  ///< sum_j F^n m_j grad W

  SCARP_INLINE ArtificialStress() {
    unrolled<Dim>([&](auto a) SCARP_LAMBDA { weighted_gradient_sum[a] = B(0); });
  }
  SCARP_INLINE void add(const PairGeometry<B, Dim>& pair, const PairMotion<B, Dim>& motion,
                        const ParticleLanes<B>& i, const B& factor, const B (&tension_j)[6],
                        B (&stress_j)[6]) {
    const B weight_j = factor * i.density;
    const B weight_i = factor * pair.density;
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
