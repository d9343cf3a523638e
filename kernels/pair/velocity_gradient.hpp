// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the velocity gradient, whose symmetric and antisymmetric parts are strain and spin
/// rate.
#pragma once

#include "kernels/pair/pair_geometry.hpp"
#include "kernels/pair/term.hpp"

namespace scarp::kernels {

/// Equation: E23, E24; L_ab = sum_j V_j (v_j - v_i)_a d_b W [1/s], row-major 3 x 3.
struct VelocityGradient : PairTerm {
  static constexpr Term term = Term::velocity_gradient;
  static constexpr const char* name = "velocity gradient";
  static constexpr SlotSet reads = velocity_slots;
  static constexpr std::array<FieldUse, 1> writes{{{"velocity_gradient", 9}}};
  static constexpr bool used(const TermSettings&) { return true; }
  static constexpr int flops(int d) { return 2 * d * d; }

  template <class B, int Dim>
  struct Sums {
    B minus_gradient[Dim * Dim];

    SCARP_INLINE Sums() {
      unrolled<Dim * Dim>([&](auto k) SCARP_LAMBDA { minus_gradient[k] = B(0); });
    }
    template <class Pair>
    SCARP_INLINE void add(Pair& pair) {
      unrolled<Dim>([&](auto a) SCARP_LAMBDA {
        unrolled<Dim>([&](auto b) SCARP_LAMBDA {
          B& sum = minus_gradient[a * Dim + b];
          sum = fma(pair.velocity[a], pair.volume_gradient[b], sum);
        });
      });
    }
    template <class Own>
    SCARP_INLINE void store(const Own& own, double* const* out) const {
      const auto part = own.template parts_for<VelocityGradient>();
      for (int a = 0; a < Dim; ++a) {
        for (int b = 0; b < Dim; ++b) {
          B total = own.fold(-minus_gradient[a * Dim + b]);
          part.add(a, b, total);
          own.put(out[3 * a + b], total);
        }
      }
    }
  };
};

}  // namespace scarp::kernels
