// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the artificial viscosity, and the approach rate that limits the time step.
#pragma once

#include "kernels/pair/momentum.hpp"

namespace scarp::kernels {

/// Equation: E26, E30; mu = h v.x/(r^2 + 0.01 h^2), Pi = (-alpha c mu + beta mu^2)/rho with pair
/// means of c and rho; acts on approach only. Adds -rho_i m_j Pi grad W to the force; keeps min mu
/// for the time step (its regularisation by 0.01 h^2 stands in for Eq. 30's r^2, at most 2 % at
/// neighbour distance).
struct Viscosity : PairTerm {
  static constexpr Term term = Term::viscosity;
  static constexpr const char* name = "artificial viscosity";
  static constexpr const char* text = "Eq. 26, on pairs that approach";
  static constexpr TermSet adds_to{Term::momentum};
  static constexpr PairNeeds needs{.regularised = true, .densities = true};
  static constexpr SlotSet reads = velocity_slots | density_slot | sound_speed_slot;
  static constexpr std::array<FieldUse, 1> writes{{{"approach_rate", 1}}};
  static constexpr bool used(const TermSettings& s) {
    return s.viscosity_alpha > 0.0 || s.viscosity_beta > 0.0;
  }
  static constexpr int flops(int d) { return 10 + 2 * d; }

  static constexpr const char* limit = "viscous";
  static double damping(double part, const double (&direction)[3]) {
    return part * direction[0] * direction[0];
  }
  /// It acts on half of the pairs, those that approach; the quadratic part by its tangent.
  static DampingRate damping_rate(const TermSettings& s, double scale, double sum) {
    const double rate = 0.5 * scale * sum;
    return {s.viscosity_alpha * rate, 2.0 * s.viscosity_beta * rate};
  }

  template <class B, int Dim>
  struct Sums {
    B lowest_mu = B(0);

    template <class Pair>
    SCARP_INLINE void add(Pair& pair) {
      const B scaled = min(pair.approach, B(0)) * pair.inverse_regularised;
      const B mu = scaled * (pair.i.density + pair.density);
      // Entries of the list beyond the support must not limit the step: their gradient is 0.
      const B zero(0);
      lowest_mu = min(lowest_mu, select(pair.gradient < zero, mu, zero));
      // rho_i rho_j Pi = mu (2 beta mu - alpha (c_i + c_j)) rho_i rho_j/(rho_i + rho_j); in
      // mu/(rho_i + rho_j) the sum of densities cancels and `scaled` is left.
      const auto alpha = pair.constants.viscosity_alpha, beta = pair.constants.viscosity_beta;
      const B speed = fma(B(2 * beta), mu, B(-alpha) * (pair.i.sound_speed + pair.sound_speed()));
      const B factor = scaled * speed * (pair.i.density * pair.density);
      auto& force = pair.template sums_of<Momentum>().force;
      unrolled<Dim>(
          [&](auto a) SCARP_LAMBDA { force[a] = fnma(factor, pair.volume_gradient[a], force[a]); });
    }
    template <class Own>
    SCARP_INLINE void store(const Own& own, double* const* out) const {
      own.put(out[0], own.fold(-lowest_mu, true));
    }
  };
};

}  // namespace scarp::kernels
