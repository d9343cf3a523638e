// SPDX-License-Identifier: BSD-3-Clause
/// Pair term of the stress diffusion, which damps noise of the stress in flowing soil.
#pragma once

#include "kernels/pair/pair_geometry.hpp"
#include "kernels/pair/term.hpp"

namespace scarp::kernels {

/// Equation: D1; d sigma_i/dt += 2 sum_j V_j D_ij psi_ij (x_ij . grad W)/(r^2 + 0.01 h^2) with
/// psi_ij = sigma_i - sigma_j less the lithostatic difference, which the stress pass takes from
/// `diffusion_slope`, over neighbours whose material has the moduli of that of i and yields too:
/// where stiffness jumps, so does the stress along the interface, which is no noise. Source: Feng
/// et al. (2021); gated by the shear rate there where D is set.
struct StressDiffusion : PairTerm {
  static constexpr Term term = Term::diffusion;
  static constexpr const char* name = "stress diffusion";
  static constexpr const char* text = "damps noise of the stress in soil that flows";
  static constexpr PairNeeds needs{.stress = true, .regularised = true};
  static constexpr ActsOn acts_on = ActsOn::soil;
  static constexpr SlotSet reads = stress_slots | diffusivity_slot;
  static constexpr std::array<FieldUse, 2> writes{{{"diffusion_rate", 6}, {"diffusion_slope", 1}}};
  static constexpr std::array<FieldUse, 1> reads_fields{{{"diffusivity", 1}}};
  /// Elastic bodies do not flow, and in them it amplifies noise (`disc_rotation`).
  static constexpr bool used(const TermSettings& s) { return s.stress_diffusion > 0.0 && s.yields; }
  static constexpr int flops(int d) { return 7 + 2 * (d == 2 ? 4 : 6) + 2 * d; }

  static constexpr const char* limit = "diffusion";
  static double damping(double part, const double (&)[3]) { return 2.0 * part; }
  /// At the cap of the diffusivity.
  static DampingRate damping_rate(const TermSettings& s, double scale, double sum) {
    return {s.stress_diffusion * scale * sum, 0.0};
  }

  template <class B, int Dim>
  struct Sums {
    static constexpr int components = Dim == 2 ? 4 : 6;
    B weight_sum = B(0);
    B weighted_stress[components];
    B slope = B(0);  ///< sum of weight times g . (x_i - x_j)

    SCARP_INLINE Sums() {
      unrolled<components>([&](auto c) SCARP_LAMBDA { weighted_stress[c] = B(0); });
    }
    template <class Pair>
    SCARP_INLINE void add(Pair& pair) {
      const B regularised = pair.inverse_regularised_distance();
      B weight = (pair.i.diffusivity + pair.diffusivity()) * pair.gradient * pair.distance_squared *
                 regularised;
      // Out of the way of scenes of one material: 3 % of a step in 3D.
      if (pair.several_materials()) [[unlikely]]
        weight = weight * pair.same_material();
      weight_sum = weight_sum + weight;
      unrolled<components>([&](auto c) SCARP_LAMBDA {
        weighted_stress[c] = fma(weight, pair.stress[c], weighted_stress[c]);
      });
      B fall(0);
      unrolled<Dim>([&](auto a) SCARP_LAMBDA {
        fall = fma(pair.offset[a], B(pair.constants.gravity[a]), fall);
      });
      slope = fma(weight, fall, slope);
    }
    template <class Own>
    SCARP_INLINE void store(const Own& own, double* const* out) const {
      for (int c = 0; c < components; ++c) {
        own.put(out[c], fms(own.value(record_stress + c), own.fold(weight_sum),
                            own.fold(weighted_stress[c])));
      }
      own.put(out[6], own.fold(slope));
    }
  };
};

}  // namespace scarp::kernels
