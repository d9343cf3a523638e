// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of what rough walls add to the velocity gradient of the soil.
#pragma once

#include "kernels/pair/velocity_gradient.hpp"

namespace scarp::kernels {

/// Where component (a, b) of H_w = V_w G_w/sum_k W_wk stands in the record of a dummy during the
/// sweep of gradients, counted from `record_density`: in slots that no pair of soil and dummy reads
/// there.
template <int Dim>
SCARP_INLINE constexpr int wall_gradient_place(int a, int b) {
  constexpr int in_plane[2][2] = {{1, 4}, {3, 2}};
  constexpr int in_space[3][3] = {{1, 4, 6}, {8, 2, 5}, {7, 0, 3}};
  return Dim == 2 ? in_plane[a % 2][b % 2] : in_space[a][b];
}

/// Equation: B5; L_j += (1/V_j) sum_w W_jw H_w, the transpose of the average by which the wall
/// takes the stress of the soil (B2), so that walls take and give no energy of their own. It is
/// stored with the velocity gradient, times M, because that is multiplied with B afterwards.
struct WallGradient : PairTerm {
  static constexpr Term term = Term::wall_gradient;
  static constexpr const char* name = "wall gradient";
  static constexpr const char* text = "strain of soil near rough walls by the walls' own average";
  static constexpr TermSet adds_to{Term::velocity_gradient};
  static constexpr PairNeeds needs{.smoothing_value = true};
  static constexpr ActsOn acts_on = ActsOn::walls;
  static constexpr SlotSet reads{};
  static constexpr SlotSet reads_of_dummies{record_density, 9};
  static constexpr bool used(const TermSettings& s) { return s.force_correction; }
  /// Of a pair of soil and dummy, with W.
  static constexpr int flops(int d) { return 10 + 2 * d * d; }

  template <class B, int Dim>
  struct Sums {
    B sum[Dim * Dim];

    SCARP_INLINE Sums() {
      unrolled<Dim * Dim>([&](auto k) SCARP_LAMBDA { sum[k] = B(0); });
    }
    template <class Pair>
    SCARP_INLINE void add(Pair& pair) {
      unrolled<Dim>([&](auto a) SCARP_LAMBDA {
        unrolled<Dim>([&](auto b) SCARP_LAMBDA {
          B& into = sum[a * Dim + b];
          into = fma(pair.smoothing_value,
                     pair.value(constant<record_density + wall_gradient_place<Dim>(a, b)>), into);
        });
      });
    }
    /// sum/V_j, which the velocity gradient adds to its own.
    struct OwnPart {
      B part[Dim * Dim];
      SCARP_INLINE void add(int a, int b, B& total) const { total = total + part[a * Dim + b]; }
    };
    template <class Own>
    SCARP_INLINE OwnPart own_part(const Own& own) const {
      // Padding has no volume.
      const B scale = B(1) / max(own.value(record_volume), B(closest<typename B::value_type>));
      OwnPart own_part;
      for (int k = 0; k < Dim * Dim; ++k) own_part.part[k] = own.fold(sum[k]) * scale;
      return own_part;
    }
    template <class Own>
    SCARP_INLINE void store(const Own&, double* const*) const {}
  };
};

}  // namespace scarp::kernels
