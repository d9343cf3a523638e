// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the moment that the corrected velocity gradient is divided by.
#pragma once

#include "kernels/pair/pair_geometry.hpp"
#include "kernels/pair/term.hpp"

namespace scarp::kernels {

/// M + w (I - M) for moments that are all but singular, of a few stray neighbours in a line or
/// plane: w rises from 0 to 1 as det M falls from `smallest_moment_determinant` to half of it, so
/// that the inverse exists and changes smoothly. `m` is the upper triangle row by row.
template <int Dim, class B>
SCARP_INLINE void keep_invertible(B (&m)[Dim * (Dim + 1) / 2]) {
  B determinant;
  if constexpr (Dim == 2) {
    determinant = m[0] * m[2] - m[1] * m[1];
  } else {
    determinant = m[0] * (m[3] * m[5] - m[4] * m[4]) - m[1] * (m[1] * m[5] - m[4] * m[2]) +
                  m[2] * (m[1] * m[4] - m[3] * m[2]);
  }
  constexpr double least = smallest_moment_determinant<Dim>;
  const B share = min(max(fnma(determinant, B(2.0 / least), B(2)), B(0)), B(1));
  unrolled<Dim>([&](auto a) SCARP_LAMBDA {
    unrolled<Dim - a>([&](auto ahead) SCARP_LAMBDA {
      constexpr int k = a * Dim - a * (a - 1) / 2 + ahead;
      m[k] = fma(share, B(ahead == 0 ? 1 : 0) - m[k], m[k]);
    });
  });
}

/// Equation: K1; moment_ab = sum_j V_j (x_j - x_i)_a d_b W [-], symmetric; the identity inside a
/// perfect, undisturbed body; where forces are corrected too, stored so that it can be inverted.
struct Moment : PairTerm {
  static constexpr Term term = Term::moment;
  static constexpr const char* name = "gradient correction";
  static constexpr const char* text =
      "moment of the corrected gradient; the density rate follows from it and is not summed";
  static constexpr SlotSet reads{};
  static constexpr std::array<FieldUse, 1> writes{{{"moment", 6}}};
  static constexpr bool used(const TermSettings& s) { return s.gradient_correction; }
  static constexpr int flops(int d) { return d * (d + 1); }

  template <class B, int Dim>
  struct Sums {
    static constexpr int size = Dim * (Dim + 1) / 2;
    B minus_moment[size];  ///< over h, upper triangle row by row

    SCARP_INLINE Sums() {
      unrolled<size>([&](auto k) SCARP_LAMBDA { minus_moment[k] = B(0); });
    }
    template <class Pair>
    SCARP_INLINE void add(Pair& pair) {
      unrolled<Dim>([&](auto a) SCARP_LAMBDA {
        unrolled<Dim - a>([&](auto ahead) SCARP_LAMBDA {
          constexpr int b = a + ahead, k = a * Dim - a * (a - 1) / 2 + ahead;
          minus_moment[k] = fma(pair.offset[a], pair.volume_gradient[b], minus_moment[k]);
        });
      });
    }
    template <class Own>
    SCARP_INLINE void store(const Own& own, double* const* out) const {
      constexpr int component[2][6] = {{xx, xy, yy}, {xx, xy, zx, yy, yz, zz}};
      B moment[size];
      for (int k = 0; k < size; ++k)
        moment[k] = own.fold(-minus_moment[k] * own.smoothing_length());
      if constexpr (Own::corrects_forces) keep_invertible<Dim>(moment);
      for (int k = 0; k < size; ++k) own.put(out[component[Dim - 2][k]], moment[k]);
    }
  };
};

}  // namespace scarp::kernels
