// SPDX-License-Identifier: BSD-3-Clause
/// The force that is conjugate to the corrected velocity gradient.
#pragma once

#include "kernels/pair/pair_geometry.hpp"
#include "kernels/pair/term.hpp"
#include "kernels/tensor.hpp"

namespace scarp::kernels {

/// Where component (a, b) of T = sigma B stands, counted from `record_stress`; from 8 on in the
/// extra line, counted from this term's first value there. T is not symmetric: a is the direction
/// of the force, b is summed with grad W. In 2D T_yx stands in place of sigma_zz, which no force
/// comes of; in 3D in that of the diffusivity, which the force does not read.
template <int Dim>
SCARP_INLINE constexpr int corrected_place(int a, int b) {
  constexpr int in_plane[2][2] = {{xx, xy}, {zz, yy}};
  constexpr int in_space[3][3] = {{xx, xy, 8}, {7, yy, yz}, {zx, 9, zz}};
  return Dim == 2 ? in_plane[a % 2][b % 2] : in_space[a][b];
}
static_assert(record_stress + 7 == record_diffusivity);
constexpr int corrected_place_of(int dimension, int a, int b) {
  return dimension == 2 ? corrected_place<2>(a, b) : corrected_place<3>(a, b);
}
/// This term's first value in the extra line.
inline constexpr int corrected_extra = 0;

/// Equation: K3; the momentum takes T = sigma B with B = M^-1 in place of sigma, so that its power
/// is minus that of the stress on the corrected gradient, sum_i V_i sigma_i : L_i. It sums nothing
/// of its own: the records then hold T.
struct ForceCorrection : PairTerm {
  static constexpr Term term = Term::force_correction;
  static constexpr const char* name = "force correction";
  static constexpr const char* text =
      "the force is conjugate to the corrected gradient: stress times inverse moment";
  static constexpr TermSet adds_to{Term::momentum};
  static constexpr SlotSet reads = stress_slots | diffusivity_slot;
  static constexpr std::array<FieldUse, 1> reads_fields{{{"force_moment", 6}}};
  static constexpr int second_slots = 2;
  static constexpr bool marked = false;
  static constexpr SecondRank second_rank = SecondRank::packed;
  static constexpr bool used(const TermSettings& s) { return s.force_correction; }
  static constexpr int flops(int) { return 0; }

  template <class B, int Dim>
  struct Sums {
    template <class Pair>
    SCARP_INLINE void add(Pair&) {}
    template <class Own>
    SCARP_INLINE void store(const Own&, double* const*) const {}
  };
};

/// T = sigma B. Equation: K3.
template <class T>
SCARP_TENSOR Tensor<T> corrected_stress(const SymTensor<T>& s, const SymTensor<T>& b) {
  const T left[3][3] = {{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
  const T right[3][3] = {{b.xx, b.xy, b.zx}, {b.xy, b.yy, b.yz}, {b.zx, b.yz, b.zz}};
  Tensor<T> out;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      out.m[i][j] = left[i][0] * right[0][j] + left[i][1] * right[1][j] + left[i][2] * right[2][j];
  }
  return out;
}

}  // namespace scarp::kernels
