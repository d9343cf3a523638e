// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the viscosity that sees only what the velocity gradient does not.
#pragma once

#include "kernels/pair/momentum.hpp"

namespace scarp::kernels {

/// Where component (a, b) of h D/2 stands in 2D, counted from `record_stress`: in slots that hold
/// nothing else there while forces are summed. In 3D it stands in the extra line, as a symmetric
/// tensor.
inline constexpr int strain_rate_place[2][2] = {{4, 7}, {7, 5}};

/// Equation: V1; the artificial viscosity of E26 without its quadratic part, on u = v_ij - (D_i +
/// D_j)/2 x_ij in place of v_ij, on pairs that part as on those that approach. D is the strain rate
/// of the corrected gradient, so that u vanishes in every linear velocity and is of third order in
/// the spacing in smooth ones; in a zigzag from row to row, which the gradient does not see, it is
/// the whole velocity. Along x_ij as all forces of pairs: angular momentum is kept.
struct HourglassViscosity : PairTerm {
  static constexpr Term term = Term::hourglass_viscosity;
  static constexpr const char* name = "hourglass viscosity";
  static constexpr const char* text = "damps zigzags that the velocity gradient does not see";
  static constexpr TermSet adds_to{Term::momentum};
  static constexpr PairNeeds needs{.regularised = true, .densities = true};
  static constexpr ActsOn acts_on = ActsOn::soil;
  static constexpr SlotSet reads = velocity_slots | density_slot | sound_speed_slot;
  static constexpr std::array<FieldUse, 1> reads_fields{{{"strain_rate", 6}}};
  static constexpr int second_slots = 6;
  static constexpr bool marked = false;
  static constexpr SecondRank second_rank = SecondRank::packed;
  static constexpr bool used(const TermSettings& s) {
    return s.force_correction && s.hourglass_viscosity > 0.0;
  }
  static constexpr int flops(int d) { return 7 + 4 * d + 3 * d * d; }

  static constexpr const char* limit = "viscous";
  static double damping(double part, const double (&direction)[3]) {
    return part * direction[0] * direction[0];
  }
  /// Unlike E26 it acts on all pairs.
  static DampingRate damping_rate(const TermSettings& s, double scale, double sum) {
    return {s.hourglass_viscosity * scale * sum, 0.0};
  }

  template <class B, int Dim>
  struct Sums {
    template <class Pair>
    SCARP_INLINE void add(Pair& pair) {
      // x.(D_i + D_j).x h/2, row by row.
      B stretch(0);
      unrolled<Dim>([&](auto a) SCARP_LAMBDA {
        B along(0);
        unrolled<Dim>([&](auto b) SCARP_LAMBDA {
          along = fma(pair.i.strain_rate[tensor_index[a][b]] + neighbours<a, b>(pair),
                      pair.offset[b], along);
        });
        stretch = fma(along, pair.offset[a], stretch);
      });
      const B scaled = (pair.approach - stretch) * pair.inverse_regularised;
      const B speed =
          B(pair.constants.hourglass_viscosity) * (pair.i.sound_speed + pair.sound_speed());
      const B factor = scaled * speed * (pair.i.density * pair.density);
      auto& force = pair.template sums_of<Momentum>().force;
      unrolled<Dim>(
          [&](auto a) SCARP_LAMBDA { force[a] = fma(factor, pair.volume_gradient[a], force[a]); });
    }
    template <class Own>
    SCARP_INLINE void store(const Own&, double* const*) const {}

   private:
    template <int A, int C, class Pair>
    static SCARP_INLINE B neighbours(const Pair& pair) {
      if constexpr (Dim == 2) {
        return pair.value(constant<record_stress + strain_rate_place[A][C]>);
      } else {
        return pair.template second<HourglassViscosity>(constant<tensor_index[A][C]>);
      }
    }
  };
};

}  // namespace scarp::kernels
