// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the artificial stress and its weight F^n.
#pragma once

#include "kernels/pair/artificial_stress_tensor.hpp"
#include "kernels/pair/force_correction.hpp"
#include "kernels/pair/momentum.hpp"

namespace scarp::kernels {

/// Equation: E20, E27; rho_i m_j F^n (R_i + R_j) . grad W: R_j joins the stress of the neighbour,
/// and the part with R_i is multiplied once after the loop. The second record line holds rho R,
/// zero for a particle in compression. With the force correction R B takes the place of R (K3), in
/// 3D its symmetric part.
struct ArtificialStress : PairTerm {
  static constexpr Term term = Term::artificial_stress;
  static constexpr const char* name = "artificial stress";
  static constexpr const char* text =
      "skipped where no particle of a block is in tension; 65 bytes per particle once one is";
  static constexpr const char* left_out = "no test for tension, no second record line";
  static constexpr TermSet adds_to{Term::momentum};
  static constexpr PairNeeds needs{.stress = true, .tension_factor = true};
  static constexpr SlotSet reads = density_slot;
  static constexpr std::array<FieldUse, 3> reads_fields{
      {{"stress", 6}, {"density", 1}, {"force_moment", 6, true}}};
  static constexpr int second_slots = 6;
  static constexpr SecondRank second_rank = SecondRank::tensor;
  static constexpr bool used(const TermSettings& s) { return s.artificial_stress > 0.0; }
  /// At work, which depends on the state; with the factor F^n.
  static constexpr int flops(int d) { return 28 + 2 * d + d * (d + 1); }

  /// Writes rho R of particle k, since the sweep divides by one density only; returns false, and
  /// writes nothing, if no principal stress is tensile.
  static bool second_line(const TermSettings& s, int dimension, const double* const* fields,
                          std::int64_t k, double* out) {
    const auto stress = [&](int c) { return fields[c] != nullptr ? fields[c][k] : 0.0; };
    const SymTensor<double> sigma{stress(xx), stress(yy), stress(zz),
                                  stress(xy), stress(yz), stress(zx)};
    if (in_compression(sigma, dimension)) return false;
    SymTensor<double> tensile = positive_part(sigma, dimension);
    if (fields[7] != nullptr) {
      const auto moment = [&](int c) {
        return c != zz && fields[7 + c] != nullptr ? fields[7 + c][k] : 0.0;
      };
      const double across = dimension == 3 ? fields[7 + zz][k] : 1.0;
      const Tensor<double> corrected = corrected_stress(
          tensile, inverse_of(SymTensor<double>{moment(xx), moment(yy), across, moment(xy),
                                                moment(yz), moment(zx)}));
      tensile = symmetric_part(corrected);
      if (dimension == 2) {
        tensile.xy = corrected.m[0][1];
        tensile.zz = corrected.m[1][0];
      }
    }
    const double factor = -s.artificial_stress / fields[6][k];
    out[xx] = factor * tensile.xx;
    out[yy] = factor * tensile.yy;
    out[zz] = factor * tensile.zz;
    out[xy] = factor * tensile.xy;
    out[yz] = factor * tensile.yz;
    out[zx] = factor * tensile.zx;
    return true;
  }

  template <class B, int Dim>
  struct Sums {
    B weighted_gradient_sum[Dim];  ///< sum_j F^n m_j grad W

    SCARP_INLINE Sums() {
      unrolled<Dim>([&](auto a) SCARP_LAMBDA { weighted_gradient_sum[a] = B(0); });
    }
    template <class Pair>
    SCARP_INLINE void add(Pair& pair) {
      const B weight_j = pair.tension_factor * pair.i.density;
      const B weight_i = pair.tension_factor * pair.density;
      B tension_j[6];
      pair.template take_second<ArtificialStress>(tension_j);
      unrolled<Dim>([&](auto a) SCARP_LAMBDA {
        B& sum = weighted_gradient_sum[a];
        sum = fma(weight_i, pair.volume_gradient[a], sum);
        unrolled<Dim>([&](auto b) SCARP_LAMBDA {
          if constexpr (a <= b || Pair::corrected) {
            B& stress = pair.force_stress(a, b);
            stress = fma(weight_j, tension_j[place<Pair::corrected>(a, b)], stress);
          }
        });
      });
    }

    /// The part with R_i, which the momentum adds to its own.
    template <bool Corrected>
    struct OwnPart {
      bool there;
      B tension[6];
      B sums[Dim];
      SCARP_INLINE void add(int a, int b, B& total) const {
        // The line holds rho_i R_i, which is what E20 times rho_i asks for.
        if (there) total = fma(tension[place<Corrected>(a, b)], sums[b], total);
      }
    };
    template <class Own>
    SCARP_INLINE OwnPart<Own::corrected> own_part(const Own& own) const {
      OwnPart<Own::corrected> part{own.has_marked(), {}, {}};
      if (part.there) {
        for (int c = 0; c < (Dim == 2 ? 4 : 6); ++c)
          part.tension[c] = own.template second<ArtificialStress>(c);
      }
      for (int a = 0; a < Dim; ++a) part.sums[a] = own.fold(weighted_gradient_sum[a]);
      return part;
    }
    template <class Own>
    SCARP_INLINE void store(const Own&, double* const*) const {}

   private:
    template <bool Corrected>
    static constexpr int place(int a, int b) {
      return Corrected && Dim == 2 ? corrected_place_of(2, a, b) : tensor_place(a, b);
    }
  };
};

}  // namespace scarp::kernels
