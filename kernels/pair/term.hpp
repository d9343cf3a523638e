// SPDX-License-Identifier: BSD-3-Clause
/// What a pair term says of itself: what it reads, writes, costs, and how it limits the time step.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "kernels/particle_view.hpp"

namespace scarp::kernels {

/// The pair terms, in the order of `PairTerms` (list.hpp), which is the order they are summed in.
enum class Term : std::uint32_t {
  continuity,
  velocity_gradient,
  moment,
  wall_gradient,
  diffusion,
  artificial_stress,
  force_correction,
  momentum,
  viscosity,
  hourglass_viscosity
};
inline constexpr std::size_t term_count = static_cast<std::size_t>(Term::hourglass_viscosity) + 1;

/// A set of pair terms: what a scene uses, what a sweep is compiled for.
struct TermSet {
  std::uint32_t bits = 0;

  constexpr TermSet() = default;
  constexpr TermSet(std::initializer_list<Term> terms) {
    for (const Term term : terms) bits |= bit(term);
  }
  constexpr bool has(Term term) const { return (bits & bit(term)) != 0; }
  /// True if every term of `other` is in this set.
  constexpr bool covers(TermSet other) const { return (other.bits & ~bits) == 0; }
  constexpr TermSet operator|(TermSet other) const { return of(bits | other.bits); }
  constexpr TermSet operator&(TermSet other) const { return of(bits & other.bits); }
  constexpr TermSet without(TermSet other) const { return of(bits & ~other.bits); }
  friend constexpr bool operator==(TermSet, TermSet) = default;

 private:
  static constexpr std::uint32_t bit(Term term) { return 1u << static_cast<std::uint32_t>(term); }
  static constexpr TermSet of(std::uint32_t bits) {
    TermSet set;
    set.bits = bits;
    return set;
  }
};

/// Slots of a record that are read.
struct SlotSet {
  std::uint32_t bits = 0;

  constexpr SlotSet() = default;
  /// So many slots from `first` on.
  constexpr SlotSet(int first, int count) : bits(((1u << count) - 1) << first) {}
  constexpr bool has(int slot) const { return (bits >> slot & 1u) != 0; }
  constexpr SlotSet operator|(SlotSet other) const {
    SlotSet set;
    set.bits = bits | other.bits;
    return set;
  }
};
inline constexpr SlotSet position_slots{record_x, 3}, volume_slot{record_volume, 1},
    velocity_slots{record_velocity_x, 3}, density_slot{record_density, 1},
    stress_slots{record_stress, 6}, sound_speed_slot{record_sound_speed, 1},
    diffusivity_slot{record_diffusivity, 1};

/// A particle field by its name in the engine's table, and the components it has in 3D.
struct FieldUse {
  const char* name;
  int components;
  bool if_stored = false;  ///< read where another term has it stored
};

/// Values of a pair that several terms may want; a sweep computes those that one of its terms does.
struct PairNeeds {
  bool stress = false;       ///< of j
  bool regularised = false;  ///< 1/((r/h)^2 + 0.01)
  bool densities = false;    ///< ... over rho_i + rho_j
  bool tension_factor = false;
  bool smoothing_value = false;  ///< W

  constexpr PairNeeds operator|(const PairNeeds& o) const {
    return {stress || o.stress, regularised || o.regularised, densities || o.densities,
            tension_factor || o.tension_factor, smoothing_value || o.smoothing_value};
  }
};

/// What a scene's numerics ask of the pair terms.
struct TermSettings {
  bool gradient_correction = true;
  bool force_correction = false;  ///< only with `gradient_correction`, whose conjugate it is
  bool yields = false;            ///< any of the scene's materials does
  double viscosity_alpha = 0.0;
  double viscosity_beta = 0.0;
  double hourglass_viscosity = 0.0;
  double artificial_stress = 0.0;  ///< epsilon of Eq. 27
  double stress_diffusion = 0.0;   ///< cap of the diffusivity in h c
};

/// Rate at which a dissipative term damps the shortest wave of a lattice: (a c + b w)/h per second,
/// with the signal speed c and the speed of approach w.
struct DampingRate {
  double signal = 0.0;    ///< a
  double approach = 0.0;  ///< b
};

/// What a particle of soil meets: soil or images, dummies, inner points of walls without a volume.
enum class Neighbour { soil, dummy, inner };
/// Which pairs of a soil particle a term is summed over; only terms of `walls` of inner points.
enum class ActsOn { all, soil, walls };

/// How the values of a term in the second record line turn under reflection; not at all where they
/// are packed for images too.
enum class SecondRank { scalars, tensor, packed };

/// What a term need not say. Beyond this a term has
///   term, name           its place in the list; its name in `scarp check` if `text` is not empty
///   reads                slots of the records of i and of soil j, besides position and volume
///   writes               fields it stores
///   used(settings)       whether a scene sums it
///   flops(dimension)     of one pair: a multiply-add counts 2, square root and division 1 each,
///                        maximum, minimum and selection 0
///   Sums<B, Dim>         what it keeps over the pairs of a cluster: add(pair), store(own, out)
struct PairTerm {
  static constexpr const char* text = "";      ///< what `scarp check` says; empty: every scene's
  static constexpr const char* left_out = "";  ///< what it says where a scene does without it
  static constexpr TermSet adds_to{};          ///< terms whose sums it adds to, which it needs
  static constexpr PairNeeds needs{};
  static constexpr ActsOn acts_on = ActsOn::all;
  static constexpr SlotSet reads_of_dummies{};  ///< where j is a dummy, besides `reads`
  static constexpr std::array<FieldUse, 0> writes{};
  /// Fields beyond the state of every run; `second_line` gets the arrays of all of them.
  static constexpr std::array<FieldUse, 0> reads_fields{};
  /// Values it has beyond the record. If `marked`, they stand in the second line, and it adds
  /// nothing to a pair whose two lines are both zero: blocks of such pairs skip it. Else they stand
  /// in the extra line, which all pairs read; 2D finds room for those in the record.
  static constexpr int second_slots = 0;
  static constexpr bool marked = true;
  static constexpr SecondRank second_rank = SecondRank::scalars;
  /// Name of its limit on the time step (`step_limit_names`); null: it has none. A dissipative term
  /// has damping(part, direction), what a neighbour in that direction adds to its sum over a
  /// lattice, `part` being V |W'|/r (1 - cos k.x) with lengths in h; and damping_rate(settings,
  /// scale, sum). Equation: T1.
  static constexpr const char* limit = nullptr;
};

}  // namespace scarp::kernels
