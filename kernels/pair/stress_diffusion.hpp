// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the stress diffusion that quiets noise in flowing soil.
#pragma once

#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// Equation: D1; d sigma_i/dt += 2 sum_j V_j D_ij psi_ij (x_ij . grad W)/(r^2 + 0.01 h^2) with
/// psi_ij = sigma_i - sigma_j less the lithostatic difference, which the stress pass takes from
/// `slope`. Source: Feng et al. (2021); gated by the shear rate there where D is set.
template <class B, int Dim>
struct StressDiffusion {
  static constexpr int components = Dim == 2 ? 4 : 6;
  B weight_sum = B(0);
  B weighted_stress[components];
  B slope = B(0);  ///< sum of weight times g . (x_i - x_j)

  SCARP_INLINE StressDiffusion() {
    unrolled<components>([&](auto c) SCARP_LAMBDA { weighted_stress[c] = B(0); });
  }
  template <class Real>
  SCARP_INLINE void add(const PairGeometry<B, Dim>& pair, const ParticleLanes<B>& i,
                        const B& diffusivity_j, const B& inverse_regularised,
                        const B (&stress_j)[6], const Real (&gravity)[3]) {
    const B weight = (i.diffusivity + diffusivity_j) * pair.gradient * pair.distance_squared *
                     inverse_regularised;
    weight_sum = weight_sum + weight;
    unrolled<components>([&](auto c) SCARP_LAMBDA {
      weighted_stress[c] = xsimd::fma(weight, stress_j[c], weighted_stress[c]);
    });
    B fall(Real(0));
    unrolled<Dim>([&](auto a)
                      SCARP_LAMBDA { fall = xsimd::fma(pair.offset[a], B(gravity[a]), fall); });
    slope = xsimd::fma(weight, fall, slope);
  }
};

}  // namespace scarp::kernels
