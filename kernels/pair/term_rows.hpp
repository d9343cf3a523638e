// SPDX-License-Identifier: BSD-3-Clause
/// What the pair terms say of themselves as one table, for all that happens outside of sweeps.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "kernels/pair/list.hpp"

namespace scarp::kernels {

/// One pair term; the members are those of its struct (PairTerm).
struct TermRow {
  Term term;
  const char* name;
  const char* text;
  const char* left_out;
  TermSet adds_to;
  SlotSet reads, reads_of_dummies;
  std::span<const FieldUse> reads_fields, writes;
  int first_output;  ///< of its values in PairSweepView::output
  int second_slots;
  bool marked;
  int first_second;  ///< of its values in the second line
  SecondRank second_rank;
  const char* limit;
  bool (*used)(const TermSettings&);
  int (*flops)(int dimension);
  double (*damping)(double part, const double (&direction)[3]);  ///< null without a limit
  DampingRate (*damping_rate)(const TermSettings&, double scale, double sum);
  /// Values of particle k for the second line into `out`; false, and nothing written, if all are 0.
  /// `fields` are the arrays of `reads_fields`, null where a component is not stored. Null
  /// function: the term has none there, or they are packed with the records.
  bool (*second_line)(const TermSettings&, int dimension, const double* const* fields,
                      std::int64_t k, double* out);
};

template <class List, class T>
constexpr TermRow term_row() {
  TermRow row{T::term,
              T::name,
              T::text,
              T::left_out,
              T::adds_to,
              T::reads | position_slots | volume_slot,
              T::reads_of_dummies,
              T::reads_fields,
              T::writes,
              first_output<List, T>,
              T::second_slots,
              T::marked,
              first_second<List, T>,
              T::second_rank,
              T::limit,
              &T::used,
              &T::flops,
              nullptr,
              nullptr,
              nullptr};
  if constexpr (T::limit != nullptr) {
    row.damping = &T::damping;
    row.damping_rate = &T::damping_rate;
  }
  if constexpr (T::second_slots > 0 && T::marked) row.second_line = &T::second_line;
  return row;
}

template <class... T>
constexpr std::array<TermRow, sizeof...(T)> rows_of(TermList<T...>) {
  return {term_row<TermList<T...>, T>()...};
}
/// By the number of the term.
inline constexpr std::array<TermRow, term_count> term_rows = rows_of(PairTerms{});

/// The terms that a scene with these settings sums.
constexpr TermSet used_terms(const TermSettings& settings) {
  TermSet set;
  for (const TermRow& row : term_rows) {
    if (row.used(settings)) set = set | TermSet{row.term};
  }
  return set;
}
/// The half of a set that is summed of velocities: the terms of which nothing goes into a force.
constexpr TermSet gradient_terms(TermSet set) {
  for (const TermRow& row : term_rows) {
    if (row.term == Term::momentum || row.adds_to.has(Term::momentum))
      set = set.without({row.term});
  }
  return set;
}
/// ... and the half that goes into the force.
constexpr TermSet force_terms(TermSet set) { return set.without(gradient_terms(set)); }

/// The slots of a record that any term of a set reads; of dummies also others.
constexpr SlotSet slots_read(TermSet set) {
  SlotSet slots;
  for (const TermRow& row : term_rows) {
    if (set.has(row.term)) slots = slots | row.reads;
  }
  return slots;
}

}  // namespace scarp::kernels
