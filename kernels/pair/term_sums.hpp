// SPDX-License-Identifier: BSD-3-Clause
/// The sums of all terms of a sweep, each under the type of its term.
#pragma once

#include "kernels/pair/list.hpp"
#include "kernels/simd.hpp"

namespace scarp::kernels {

template <class B, int Dim, TermSet Set, class List>
class TermSums;

template <class B, int Dim, TermSet Set, class... T>
class TermSums<B, Dim, Set, TermList<T...>> {
  struct Nothing {};
  /// One type per term, so that what is not summed takes no room and no two are the same base.
  template <class Term, bool Used>
  struct Slot {
    Nothing sums;
  };
  template <class Term>
  struct Slot<Term, true> {
    typename Term::template Sums<B, Dim> sums;
  };
  template <class Term>
  using SlotOf = Slot<Term, Set.has(Term::term)>;
  struct Slots : SlotOf<T>... {};
  Slots slots_;

  template <class Term, class Part>
  struct Tagged {
    Part part;
  };
  struct NoPart {
    SCARP_INLINE void add(int, int, const B&) const {}
  };
  template <class... Part>
  struct Parts : Part... {
    SCARP_INLINE void add(int a, int b, B& total) const {
      (static_cast<const Part&>(*this).part.add(a, b, total), ...);
    }
  };
  template <class Target, class Term, class Own>
  SCARP_INLINE auto part_of(const Own& own) const {
    if constexpr (Term::adds_to.has(Target::term) && requires { of<Term>().own_part(own); }) {
      return Tagged<Term, decltype(of<Term>().own_part(own))>{of<Term>().own_part(own)};
    } else {
      return Tagged<Term, NoPart>{};
    }
  }

 public:
  static constexpr TermSet set = Set;

  template <class Term>
  SCARP_INLINE auto& of() {
    return static_cast<SlotOf<Term>&>(slots_).sums;
  }
  template <class Term>
  SCARP_INLINE const auto& of() const {
    return static_cast<const SlotOf<Term>&>(slots_).sums;
  }
  /// f(term, sums) for each term of the set, in the order of the list.
  template <class F>
  SCARP_INLINE void each(F&& f) {
    (
        [&]() SCARP_LAMBDA {
          if constexpr (Set.has(T::term)) f(T{}, of<T>());
        }(),
        ...);
  }
  /// What the terms that have a part of their own in what `Target` stores add to it, together.
  template <class Target, class Own>
  SCARP_INLINE auto own_parts(const Own& own) const {
    return Parts<decltype(part_of<Target, T>(own))...>{part_of<Target, T>(own)...};
  }
};

}  // namespace scarp::kernels
