// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the momentum equation.
#pragma once

#include "kernels/pair/pair_geometry.hpp"
#include "kernels/pair/term.hpp"

namespace scarp::kernels {

/// Equation: E20; rho_i dv_i/dt = sigma_i . sum_j V_j grad W + sum_j V_j sigma_j . grad W: sigma_i
/// is multiplied once after the loop. With the force correction T takes the place of sigma (K3).
/// Stores the acceleration without gravity [m/s2]; terms that add to it add to `force`, or to the
/// stress of j before this term takes it.
struct Momentum : PairTerm {
  static constexpr Term term = Term::momentum;
  static constexpr const char* name = "momentum";
  static constexpr PairNeeds needs{.stress = true};
  static constexpr SlotSet reads = density_slot | stress_slots;
  static constexpr std::array<FieldUse, 1> writes{{{"acceleration", 3}}};
  static constexpr bool used(const TermSettings&) { return true; }
  static constexpr int flops(int d) { return 2 * d * d + d; }

  template <class B, int Dim>
  struct Sums {
    B gradient_sum[Dim];
    B force[Dim];

    SCARP_INLINE Sums() {
      unrolled<Dim>([&](auto a) SCARP_LAMBDA { gradient_sum[a] = force[a] = B(0); });
    }
    template <class Pair>
    SCARP_INLINE void add(Pair& pair) {
      unrolled<Dim>([&](auto a) SCARP_LAMBDA {
        gradient_sum[a] = gradient_sum[a] + pair.volume_gradient[a];
        unrolled<Dim>([&](auto b) SCARP_LAMBDA {
          force[a] = fma(pair.force_stress(a, b), pair.volume_gradient[b], force[a]);
        });
      });
    }
    template <class Own>
    SCARP_INLINE void store(const Own& own, double* const* out) const {
      B sums[Dim];
      for (int a = 0; a < Dim; ++a) sums[a] = own.fold(gradient_sum[a]);
      // Lanes of padding have density 1, so the quotient is finite.
      const B scale = B(1) / own.i.density;
      const auto own_part = own.template parts_for<Momentum>();
      for (int a = 0; a < Dim; ++a) {
        B total = own.fold(force[a]);
        for (int b = 0; b < Dim; ++b) {
          total = fma(own.force_stress(a, b), sums[b], total);
          own_part.add(a, b, total);
        }
        own.put(out[a], total * scale);
      }
    }
  };
};

}  // namespace scarp::kernels
