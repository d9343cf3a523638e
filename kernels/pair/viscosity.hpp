// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the artificial viscosity, and the approach rate that limits the time step.
#pragma once

#include "kernels/pair/pair_geometry.hpp"

namespace scarp::kernels {

/// Equation: E26, E30; mu = h v.x/(r^2 + 0.01 h^2), Pi = (-alpha c mu + beta mu^2)/rho with pair
/// means of c and rho; acts on approach only. Adds -rho_i m_j Pi grad W to the force; keeps min mu
/// for the time step (its regularisation by 0.01 h^2 stands in for Eq. 30's r^2, at most 2 % at
/// neighbour distance). 9 + 2 d flops.
template <class B>
struct Viscosity {
  B lowest_mu = B(0);

  template <int Dim, class Real>
  SCARP_INLINE void add(const PairGeometry<B, Dim>& pair, const PairMotion<B, Dim>& motion,
                        const ParticleLanes<B>& i, const B& sound_speed_j, Real alpha, Real beta,
                        B (&force)[Dim]) {
    const B scaled = xsimd::min(motion.approach, B(Real(0))) * pair.inverse_regularised;
    const B mu = scaled * (i.density + motion.density);
    // Entries of the list beyond the support must not limit the step: their gradient is 0.
    const B zero(Real(0));
    lowest_mu = xsimd::min(lowest_mu, xsimd::select(pair.gradient < zero, mu, zero));
    // rho_i rho_j Pi = mu (2 beta mu - alpha (c_i + c_j)) rho_i rho_j/(rho_i + rho_j); in mu/(rho_i
    // + rho_j) the sum of densities cancels and `scaled` is left.
    const B speed = xsimd::fma(B(Real(2) * beta), mu, B(-alpha) * (i.sound_speed + sound_speed_j));
    const B factor = scaled * speed * (i.density * motion.density);
    unrolled<Dim>([&](auto a) SCARP_LAMBDA {
      force[a] = xsimd::fnma(factor, motion.volume_gradient[a], force[a]);
    });
  }
};

}  // namespace scarp::kernels
