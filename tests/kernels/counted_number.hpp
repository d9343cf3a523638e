// SPDX-License-Identifier: BSD-3-Clause
/// A number that counts what is done with it, for the work of a pair.
#pragma once

#include "kernels/pair/list.hpp"

namespace scarp::test {

/// Counts as `PairTerm` says: a multiply-add 2, square root and division 1 each, maximum, minimum
/// and selection 0.
struct Counted {
  using value_type = double;
  static inline int flops = 0;

  Counted() = default;
  explicit Counted(double) {}
  static Counted after(int more) {
    flops += more;
    return {};
  }
  friend Counted operator+(Counted, Counted) { return after(1); }
  friend Counted operator-(Counted, Counted) { return after(1); }
  friend Counted operator*(Counted, Counted) { return after(1); }
  friend Counted operator/(Counted, Counted) { return after(1); }
  friend bool operator<(Counted, Counted) { return false; }
  friend Counted fma(Counted, Counted, Counted) { return after(2); }
  friend Counted fnma(Counted, Counted, Counted) { return after(2); }
  friend Counted min(Counted, Counted) { return {}; }
  friend Counted max(Counted, Counted) { return {}; }
  friend Counted select(bool, Counted, Counted) { return {}; }
  friend Counted inverse(Counted) { return after(1); }
  friend Counted inverse_sqrt(Counted) { return after(2); }
};

/// What terms ask of a pair.
template <int Dim>
struct CountedPair : kernels::PairGeometry<Counted, Dim>, kernels::PairMotion<Counted, Dim> {
  kernels::ParticleLanes<Counted> i;
  kernels::PairConstants<double> constants{};
  static constexpr bool corrected = false;
  Counted stress[6];
  kernels::Momentum::Sums<Counted, Dim> momentum;
  bool densities = false;

  Counted& force_stress(int a, int b) { return stress[kernels::tensor_index[a][b]]; }
  template <int Slot>
  Counted value(std::integral_constant<int, Slot>) const {
    return {};
  }
  Counted sound_speed() const { return {}; }
  Counted diffusivity() const { return {}; }
  bool several_materials() const { return false; }
  Counted same_material() const { return {}; }
  Counted inverse_regularised_distance() const { return Counted::after(densities ? 2 : 0); }
  template <class Term, int C>
  Counted second(std::integral_constant<int, C>) const {
    return {};
  }
  template <class Term>
  void take_second(Counted (&)[6]) const {}
  template <class Term>
  auto& sums_of() {
    return momentum;
  }
};

template <int Dim, kernels::PairNeeds Needs>
int geometry_flops() {
  Counted::flops = Dim;  // offset
  CountedPair<Dim> pair;
  kernels::complete_geometry<Needs>(
      pair, Counted(), [] { return Counted::after(1); }, pair.constants);
  return Counted::flops;
}
/// ... of each set of needs, by its bits.
template <int Dim>
int geometry_flops(const kernels::PairNeeds& needs) {
  const int bits = needs.tension_factor + 2 * needs.densities + 4 * needs.regularised;
  switch (bits) {
    case 0:
      return geometry_flops<Dim, kernels::PairNeeds{false, false, false, false}>();
    case 1:
      return geometry_flops<Dim, kernels::PairNeeds{false, false, false, true}>();
    case 4:
      return geometry_flops<Dim, kernels::PairNeeds{false, true, false, false}>();
    case 5:
      return geometry_flops<Dim, kernels::PairNeeds{false, true, false, true}>();
    case 6:
      return geometry_flops<Dim, kernels::PairNeeds{false, true, true, false}>();
    default:
      return geometry_flops<Dim, kernels::PairNeeds{false, true, true, true}>();
  }
}

template <int Dim, class... T>
int flops_of_terms(kernels::TermList<T...>, kernels::TermSet set, CountedPair<Dim>& pair) {
  Counted::flops = 0;
  (
      [&] {
        typename T::template Sums<Counted, Dim> sums;
        if (set.has(T::term) && kernels::is_summed<T>(kernels::Neighbour::soil)) sums.add(pair);
      }(),
      ...);
  return Counted::flops;
}

/// Flops of one pair of soil for these terms, from what they do.
template <int Dim>
int counted_flops(kernels::TermSet set) {
  const kernels::PairNeeds needs =
      kernels::needs_of(kernels::PairTerms{}, set, kernels::Neighbour::soil);
  CountedPair<Dim> pair;
  pair.densities = needs.densities;
  Counted::flops = Dim;  // relative velocity
  kernels::complete_motion<Counted, Dim>(pair, pair);
  // The compiler leaves out the approach where nobody asks for it.
  using enum kernels::Term;
  const bool approach = set.has(continuity) || set.has(viscosity) || set.has(hourglass_viscosity);
  const int motion = Counted::flops - (approach ? 0 : 2 * Dim - 1);
  return geometry_flops<Dim>(needs) + motion + flops_of_terms<Dim>(kernels::PairTerms{}, set, pair);
}

}  // namespace scarp::test
