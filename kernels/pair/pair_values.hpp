// SPDX-License-Identifier: BSD-3-Clause
/// What a term sees of a pair while it sums, and of its own particles when it stores.
#pragma once

#include "kernels/pair/cluster_lanes.hpp"
#include "kernels/pair/list.hpp"
#include "kernels/simd.hpp"

namespace scarp::kernels {

/// The records of two list entries, one for each half of the lanes.
template <class Arch, class Real>
class RecordPair {
  using Quad = RecordQuad<Real, Arch>;

 public:
  SCARP_INLINE RecordPair(const Real* records, std::int32_t low, std::int32_t high)
      : records_(records), low_(low), high_(high) {}
  /// Four values from slot `First` on.
  template <int First>
  SCARP_INLINE Quad quad() const {
    return Quad(records_ + std::int64_t{low_} * record_size + First,
                records_ + std::int64_t{high_} * record_size + First);
  }
  SCARP_INLINE Batch<Real, Arch> density() const {
    return quad<record_velocity_x>()(constant<record_density - record_velocity_x>);
  }

 private:
  const Real* records_;
  std::int32_t low_, high_;
};

/// The cluster's own particles: values of their records, sums over both halves, outputs.
template <class Arch, class Real, int Dim, TermSet Set, class List>
struct OwnValues {
  using B = Batch<Real, Arch>;
  static constexpr int dimension = Dim;
  const PairSweepView<Real>& view;
  ClusterLanes<Real, Arch> cluster;
  ParticleLanes<B> i;

  SCARP_INLINE OwnValues(const PairSweepView<Real>& of, std::int64_t first)
      : view(of), cluster{first} {
    i.density = value(record_density);
    i.sound_speed = value(record_sound_speed);
    i.diffusivity = value(record_diffusivity);
    for (int a = 0; a < Dim; ++a) {
      i.position[a] = value(record_x + a);
      i.velocity[a] = value(record_velocity_x + a);
    }
    i.material = view.material != nullptr ? view.material[first] : 0;
    if constexpr (Set.has(Term::hourglass_viscosity)) {
      for (int a = 0; a < Dim; ++a) {
        for (int b = a; b < Dim; ++b) {
          const int c = tensor_place(a, b);
          if constexpr (Dim == 2) {
            i.strain_rate[c] = value(record_stress + strain_rate_place[a][b]);
          } else {
            i.strain_rate[c] = cluster.load(view.extra, extra_record_size,
                                            first_second<List, HourglassViscosity> + c);
          }
        }
      }
    }
  }
  SCARP_INLINE B value(int slot) const { return cluster.load(view.records, record_size, slot); }
};

/// The same with all sums of the sweep, for a term that stores.
template <class List, class Sums, class OwnValues>
struct StoreValues {
  using B = typename OwnValues::B;
  const OwnValues& own;
  const Sums& sums;
  const decltype(OwnValues::i)& i = own.i;

  static constexpr bool corrected = Sums::set.has(Term::force_correction),
                        corrects_forces = Sums::set.has(Term::wall_gradient);

  SCARP_INLINE B value(int slot) const { return own.value(slot); }
  SCARP_INLINE bool has_marked() const { return own.view.marked != nullptr; }
  /// Component (a, b) of what the force takes for stress: a its direction, b summed with grad W.
  SCARP_INLINE B force_stress(int a, int b) const {
    if constexpr (!corrected) return value(record_stress + tensor_place(a, b));
    const int place = corrected_place_of(OwnValues::dimension, a, b);
    return place < 8 ? value(record_stress + place) : second<ForceCorrection>(place - 8);
  }
  /// Value `c` of term T in the second or the extra line.
  template <class T>
  SCARP_INLINE B second(int c) const {
    if constexpr (T::marked)
      return own.cluster.load(own.view.second, second_record_size, first_second<List, T> + c);
    return own.cluster.load(own.view.extra, extra_record_size, first_second<List, T> + c);
  }
  SCARP_INLINE B smoothing_length() const {
    return B(static_cast<typename B::value_type>(own.view.smoothing_length));
  }
  /// Sums (or takes the maximum of) both halves, into every lane.
  SCARP_INLINE B fold(const B& value, bool maximum = false) const {
    return own.cluster.fold(value, maximum);
  }
  /// Writes a folded value, unless nobody asks for it.
  SCARP_INLINE void put(double* out, const B& folded) const { own.cluster.put(out, folded); }
  /// What other terms add to what term T stores.
  template <class T>
  SCARP_INLINE auto parts_for() const {
    return sums.template own_parts<T>(*this);
  }
  template <class T>
  SCARP_INLINE const auto& sums_of() const {
    return sums.template of<T>();
  }
};

/// A pair in the second stage. `Needs` are those of the terms at work on it, `Densities` tells
/// whether the first stage has put them into `inverse_regularised`.
template <class Arch, class Real, int Dim, PairNeeds Needs, bool Densities, class List, class Sums>
struct PairValues : PairGeometry<Batch<Real, Arch>, Dim>, PairMotion<Batch<Real, Arch>, Dim> {
  using B = Batch<Real, Arch>;
  static constexpr bool corrected = Sums::set.has(Term::force_correction);
  const PairConstants<Real>& constants;
  const ParticleLanes<B>& i;
  /// Of j, and of what terms before the momentum add to it; with the force correction T row by row.
  B stress[corrected ? Dim * Dim : 6];

  SCARP_INLINE PairValues(const PairSweepView<Real>& view, const ParticleLanes<B>& own,
                          const PairGeometry<B, Dim>& geometry, std::int32_t low, std::int32_t high,
                          Sums& sums)
      : PairGeometry<B, Dim>(geometry),
        constants(view.constants),
        i(own),
        view_(view),
        low_(low),
        high_(high),
        sums_(sums),
        more_(RecordPair<Arch, Real>(view.records, low, high).template quad<record_stress + 4>()) {
    const RecordPair<Arch, Real> records(view.records, low, high);
    const auto moving = records.template quad<record_velocity_x>();
    this->density = moving(constant<record_density - record_velocity_x>);
    unrolled<Dim>([&](auto a) SCARP_LAMBDA { this->velocity[a] = i.velocity[a] - moving(a); });
    complete_motion<B, Dim>(*this, *this);
    if constexpr (Needs.stress) take_stress(records.template quad<record_stress>());
  }

  /// Component (a, b) of what the force takes for the stress of j: a its direction, b summed with
  /// grad W.
  SCARP_INLINE B& force_stress(int a, int b) {
    return stress[corrected ? a * Dim + b : tensor_place(a, b)];
  }
  /// Any value of the record of j.
  template <int Slot>
  SCARP_INLINE B value(std::integral_constant<int, Slot>) const {
    constexpr int quad = Slot / 4 * 4;
    return RecordPair<Arch, Real>(view_.records, low_, high_)
        .template quad<quad>()(constant<Slot - quad>);
  }

  SCARP_INLINE B sound_speed() const {
    return more_(constant<record_sound_speed - record_stress - 4>);
  }
  SCARP_INLINE B diffusivity() const {
    return more_(constant<record_diffusivity - record_stress - 4>);
  }
  /// 1/((r/h)^2 + 0.01).
  SCARP_INLINE B inverse_regularised_distance() const {
    if constexpr (Densities) return this->inverse_regularised * (i.density + this->density);
    return this->inverse_regularised;
  }
  SCARP_INLINE bool several_materials() const { return view_.material != nullptr; }
  /// 1 where j is of the material of i, else 0. Pre: several_materials().
  SCARP_INLINE B same_material() const {
    const Real low = view_.material[low_] == i.material ? Real(1) : Real(0);
    const Real high = view_.material[high_] == i.material ? Real(1) : Real(0);
    return [&]<int... Lane>(std::integer_sequence<int, Lane...>) SCARP_LAMBDA {
      return B({(Lane < cluster_size<Real, Arch> ? low : high)...});
    }
    (std::make_integer_sequence<int, lanes<Real, Arch>>{});
  }
  /// Value `c` of term T in the second or the extra lines.
  template <class T, int C>
  SCARP_INLINE B second(std::integral_constant<int, C>) const {
    constexpr int place = first_second<List, T> + C, quad = place / 4 * 4;
    if constexpr (T::marked) return second_quad<quad>()(constant<place - quad>);
    return extra_quad<quad>()(constant<place - quad>);
  }
  /// The stored components of a tensor that is all T has there.
  template <class T>
  SCARP_INLINE void take_second(B (&out)[6]) const {
    constexpr int first = first_second<List, T>;
    static_assert(first % 4 == 0, "vectors load four values from aligned places");
    take_tensor<Dim>(second_quad<first>(), second_quad<first + 4>(), out);
  }
  /// What term T sums, for a term that adds to it.
  template <class T>
  SCARP_INLINE auto& sums_of() {
    return sums_.template of<T>();
  }

 private:
  template <class Quad>
  SCARP_INLINE void take_stress(const Quad& first) {
    if constexpr (corrected) {
      unrolled<Dim>([&](auto a) SCARP_LAMBDA {
        unrolled<Dim>([&](auto b) SCARP_LAMBDA {
          constexpr int place = corrected_place<Dim>(a, b);
          B& out = stress[a * Dim + b];
          if constexpr (place < 4) {
            out = first(constant<place>);
          } else if constexpr (place < 8) {
            out = more_(constant<place - 4>);
          } else {
            out = second<ForceCorrection>(constant<place - 8>);
          }
        });
      });
    } else {
      take_tensor<Dim>(first, more_, stress);
    }
  }
  template <int First>
  SCARP_INLINE RecordQuad<Real, Arch> second_quad() const {
    return RecordQuad<Real, Arch>(view_.second + std::int64_t{low_} * second_record_size + First,
                                  view_.second + std::int64_t{high_} * second_record_size + First);
  }

  template <int First>
  SCARP_INLINE RecordQuad<Real, Arch> extra_quad() const {
    return RecordQuad<Real, Arch>(view_.extra + std::int64_t{low_} * extra_record_size + First,
                                  view_.extra + std::int64_t{high_} * extra_record_size + First);
  }

  const PairSweepView<Real>& view_;
  std::int32_t low_, high_;
  Sums& sums_;
  RecordQuad<Real, Arch> more_;
};

}  // namespace scarp::kernels
