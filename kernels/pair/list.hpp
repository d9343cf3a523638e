// SPDX-License-Identifier: BSD-3-Clause
/// The pair terms, and what follows from their list: places of their outputs, needs, work.
#pragma once

#include <type_traits>

#include "kernels/pair/artificial_stress.hpp"
#include "kernels/pair/continuity.hpp"
#include "kernels/pair/force_correction.hpp"
#include "kernels/pair/hourglass_viscosity.hpp"
#include "kernels/pair/moment.hpp"
#include "kernels/pair/momentum.hpp"
#include "kernels/pair/stress_diffusion.hpp"
#include "kernels/pair/velocity_gradient.hpp"
#include "kernels/pair/viscosity.hpp"
#include "kernels/pair/wall_gradient.hpp"

namespace scarp::kernels {

template <class... T>
struct TermList {
  static constexpr std::size_t size = sizeof...(T);
};

/// The one list: a term stands here, in `Term` and in its own header. Terms that change the stress
/// of the neighbour come before the momentum, which takes it; terms that add to the force after.
using PairTerms =
    TermList<Continuity, VelocityGradient, Moment, WallGradient, StressDiffusion, ArtificialStress,
             ForceCorrection, Momentum, Viscosity, HourglassViscosity>;

/// Sum of value<T>() over the terms before `Wanted` (over all of them for void).
template <class Wanted, class... T, class Value>
constexpr int sum_before(TermList<T...>, Value&& value) {
  int sum = 0;
  bool before = true;
  ((before = before && !std::is_same_v<T, Wanted>, sum += before ? value(T{}) : 0), ...);
  return sum;
}
template <class T>
constexpr int output_count_of(T) {
  int sum = 0;
  for (const FieldUse& field : T::writes) sum += field.components;
  return sum;
}
/// Where the outputs of a term begin in PairSweepView::output, its values in the second line or in
/// the extra line.
template <class List, class T>
inline constexpr int first_output = sum_before<T>(List{},
                                                  [](auto term) { return output_count_of(term); });
template <class List, class T, bool Marked = T::marked>
inline constexpr int first_second = sum_before<T>(List{}, [](auto term) {
  const bool counts = decltype(term)::marked == Marked;
  return counts * decltype(term)::second_slots;
});

/// How many values all terms of a list write, and have in the second line.
template <class List>
inline constexpr int output_count = first_output<List, void>;
template <class List, bool Marked>
inline constexpr int second_count = first_second<List, void, Marked>;

/// Whether the terms of a list stand in the order of their numbers and fit in the views.
template <class... T>
constexpr bool is_sound(TermList<T...> list) {
  std::uint32_t next = 0;
  const bool ordered = ((static_cast<std::uint32_t>(T::term) == next++) && ...);
  return ordered && output_count<decltype(list)> <= most_outputs &&
         second_count<decltype(list), true> <= second_record_size &&
         second_count<decltype(list), false> <= extra_record_size;
}
static_assert(is_sound(PairTerms{}) && PairTerms::size == term_count);
static_assert(first_second<PairTerms, ForceCorrection> == corrected_extra);

/// Whether a term is summed over pairs of soil with these.
template <class T>
constexpr bool is_summed(Neighbour neighbour) {
  if (T::acts_on == ActsOn::all) return neighbour != Neighbour::inner;
  return (T::acts_on == ActsOn::walls) == (neighbour != Neighbour::soil);
}
template <class... T>
constexpr bool is_any_summed(TermList<T...>, TermSet set, Neighbour neighbour) {
  return ((set.has(T::term) && is_summed<T>(neighbour)) || ...);
}

/// What the terms of a set want of a pair; only those that act there.
template <class... T>
constexpr PairNeeds needs_of(TermList<T...>, TermSet set, Neighbour neighbour) {
  PairNeeds needs;
  ((needs = set.has(T::term) && is_summed<T>(neighbour) ? needs | T::needs : needs), ...);
  return needs;
}
/// Whether any term of a set has values in the second line.
template <class... T>
constexpr bool reads_second(TermList<T...>, TermSet set) {
  return ((set.has(T::term) && T::second_slots > 0 && T::marked) || ...);
}
/// ... in the extra line.
template <class... T>
constexpr bool reads_extra(TermList<T...>, TermSet set, int dimension) {
  return dimension == 3 && ((set.has(T::term) && T::second_slots > 0 && !T::marked) || ...);
}

/// The terms that are skipped where no second line is marked.
template <class... T>
constexpr TermSet marked_terms(TermList<T...>) {
  TermSet set;
  ((set = T::second_slots > 0 && T::marked ? set | TermSet{T::term} : set), ...);
  return set;
}

/// Flops of one pair of soil in a sweep over these terms; the artificial stress counts as at work.
template <class... T>
constexpr int pair_flops(TermList<T...> list, int d, TermSet set) {
  const PairNeeds needs = needs_of(list, set, Neighbour::soil);
  int flops = 3 * d + 16;           // offset, 1/r, slope of W, V_j grad W / r
  if (needs.densities) flops += 4;  // regularised denominator and densities
  if (needs.regularised && set.has(Term::diffusion)) flops += 2;  // the denominator by itself
  flops += 2 * d;                                                 // relative velocity, V_j grad W
  const TermSet approaching{Term::continuity, Term::viscosity, Term::hourglass_viscosity};
  if (!((set & approaching) == TermSet{})) flops += 2 * d - 1;  // approach
  ((flops += set.has(T::term) && is_summed<T>(Neighbour::soil) ? T::flops(d) : 0), ...);
  return flops;
}

}  // namespace scarp::kernels
