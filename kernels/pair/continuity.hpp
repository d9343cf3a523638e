// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the continuity equation.
#pragma once

#include "kernels/pair/pair_geometry.hpp"
#include "kernels/pair/term.hpp"

namespace scarp::kernels {

/// Equation: E19; d rho_i/dt = sum_j m_j (v_i - v_j) . grad_i W [kg/m3/s]. Where the gradients are
/// corrected, the density rate follows from them instead (K1).
struct Continuity : PairTerm {
  static constexpr Term term = Term::continuity;
  static constexpr const char* name = "continuity";
  static constexpr SlotSet reads = velocity_slots | density_slot;
  static constexpr std::array<FieldUse, 1> writes{{{"density_rate", 1}}};
  static constexpr bool used(const TermSettings& s) { return !s.gradient_correction; }
  static constexpr int flops(int) { return 3; }

  template <class B, int Dim>
  struct Sums {
    B density_rate = B(0);

    template <class Pair>
    SCARP_INLINE void add(Pair& pair) {
      density_rate = fma(pair.density * pair.gradient, pair.approach, density_rate);
    }
    template <class Own>
    SCARP_INLINE void store(const Own& own, double* const* out) const {
      own.put(out[0], own.fold(density_rate));
    }
  };
};

}  // namespace scarp::kernels
