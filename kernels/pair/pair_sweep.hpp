// SPDX-License-Identifier: BSD-3-Clause
/// The pair sweep: a set of pair terms in one loop over the neighbours of clusters of particles.
#pragma once

#include "kernels/neighbour_block.hpp"
#include "kernels/pair/cluster_lanes.hpp"
#include "kernels/pair/list.hpp"
#include "kernels/pair/pair_values.hpp"
#include "kernels/pair/term_sums.hpp"

namespace scarp::kernels {

/// One cluster of particles in the lanes of a vector, twice: the lower half meets the even, the
/// upper half the odd entries of the list. Blocks of eight entries are staged, first geometry, then
/// accumulation, so that four independent chains hide the latency of each other. What is not in
/// `Set` costs neither instructions nor memory.
template <class Arch, class Real, int Dim, TermSet Set, class List>
class ClusterSweep {
  static constexpr int half = cluster_size<Real, Arch>;
  static constexpr int stages = entry_block / 2;
  static constexpr int prefetch_distance = 2;  ///< blocks
  static constexpr bool second = reads_second(List{}, Set), extra = reads_extra(List{}, Set, Dim);
  using B = Batch<Real, Arch>;
  using Quad = RecordQuad<Real, Arch>;
  using Geometry = PairGeometry<B, Dim>;
  using Sums = TermSums<B, Dim, Set, List>;

 public:
  SCARP_INLINE ClusterSweep(const PairSweepView<Real>& view, std::int64_t cluster)
      : view_(view), own_(view, cluster * half) {
    if constexpr (second) {
      for (int l = 0; l < half; ++l)
        cluster_marked_ |= view.marked != nullptr && view.marked[cluster * half + l] != 0;
    }
  }

  template <Neighbour With>
  SCARP_INLINE void add_blocks(std::int64_t begin, std::int64_t end) {
    for (std::int64_t block = begin; block < end; ++block) {
      prefetch(block + prefetch_distance);  // lists end in empty blocks: this one exists
      const NeighbourBlock j(view_.neighbours, block);
      if constexpr (second) {
        if (is_marked(j)) {
          add_block<With, true>(j);
          continue;
        }
      }
      add_block<With, false>(j);
    }
  }

  SCARP_INLINE void store() {
    sums_.each([&]<class T>(const T&, const auto& sum) SCARP_LAMBDA {
      sum.store(StoreValues<List, Sums, Own>{own_, sums_}, view_.output + first_output<List, T>);
    });
  }

 private:
  using Own = OwnValues<Arch, Real, Dim, Set, List>;

  /// Fetches the records of a block. Padding asks for one past the page, which is harmless and
  /// cheaper than telling it from neighbours.
  SCARP_INLINE void prefetch(std::int64_t block) const {
    constexpr int line = 64 / sizeof(Real);
    const std::uint16_t* place = view_.neighbours.place + block * entry_block;
    const std::int64_t page = view_.neighbours.page[block];
    for (int entry = 0; entry < entry_block; ++entry) {
      const std::int64_t k = page + place[entry];
      for (int value = 0; value < record_size; value += line)
        __builtin_prefetch(view_.records + k * record_size + value);
      if constexpr (second) {
        if (view_.marked != nullptr) __builtin_prefetch(view_.second + k * second_record_size);
      }
      if constexpr (extra) __builtin_prefetch(view_.extra + k * extra_record_size);
    }
  }

  template <Neighbour With, bool Marked>
  SCARP_INLINE void add_block(const NeighbourBlock& j) {
    Geometry pairs[stages];
    unrolled<stages>([&](auto s) SCARP_LAMBDA {
      geometry<With, Marked>(j.record[2 * s], j.record[2 * s + 1], pairs[s]);
    });
    unrolled<stages>([&](auto s) SCARP_LAMBDA {
      accumulate<With, Marked>(pairs[s], j.record[2 * s], j.record[2 * s + 1]);
    });
  }

  /// Terms with values in the second line take no part in blocks without marks.
  template <bool Marked>
  static constexpr TermSet at_work = Marked ? Set : Set.without(marked_terms(List{}));

  template <Neighbour With, bool Marked>
  SCARP_INLINE void geometry(std::int32_t low, std::int32_t high, Geometry& pair) const {
    const RecordPair<Arch, Real> records(view_.records, low, high);
    const Quad where = records.template quad<record_x>();
    unrolled<Dim>([&](auto a) SCARP_LAMBDA {
      pair.offset[a] = position_difference<Arch>(own_.i.position[a], where(a));
    });
    constexpr PairNeeds needs = needs_of(List{}, at_work<Marked>, With);
    complete_geometry<needs>(
        pair, where(constant<record_volume - record_x>),
        [&]() SCARP_LAMBDA { return own_.i.density + records.density(); }, view_.constants);
  }

  template <Neighbour With, bool Marked>
  SCARP_INLINE void accumulate(const Geometry& geometry, std::int32_t low, std::int32_t high) {
    PairValues<Arch, Real, Dim, needs_of(List{}, at_work<Marked>, With),
               needs_of(List{}, at_work<Marked>, With).densities, List, Sums>
        pair(view_, own_.i, geometry, low, high, sums_);
    sums_.each([&]<class T>(const T&, auto& sum) SCARP_LAMBDA {
      if constexpr (at_work<Marked>.has(T::term) && is_summed<T>(With)) sum.add(pair);
    });
  }

  /// True if the second line of any entry of the block or any particle of the cluster is not zero.
  SCARP_INLINE bool is_marked(const NeighbourBlock& j) const {
    if (view_.marked == nullptr || cluster_marked_) return cluster_marked_;
    unsigned any = 0;
    for (const std::int32_t k : j.record) any |= view_.marked[k];
    return any != 0;
  }

  const PairSweepView<Real>& view_;
  Own own_;
  bool cluster_marked_ = false;
  Sums sums_;
};

/// Sweeps the active clusters number [begin, end): reads records and lists, writes the rates of
/// their particles.
/// Pre: lists are followed by two empty blocks, records by the far record. Errors: none, hot path.
/// Accuracy: 64 eps x neighbours of the largest term (tested).
template <class Arch, class Real, int Dim, TermSet Set, class List = PairTerms>
void pair_sweep(const PairSweepView<Real>& view, std::int64_t begin, std::int64_t end) {
  const NeighbourView& lists = view.neighbours;
  for (std::int64_t n = begin; n < end; ++n) {
    const std::int64_t cluster = view.clusters[n];
    ClusterSweep<Arch, Real, Dim, Set, List> sweep(view, cluster);
    const std::int64_t walls = lists.wall_begin[cluster], inner = lists.wall_end[cluster],
                       last = lists.soil_begin[cluster + 1];
    sweep.template add_blocks<Neighbour::soil>(lists.soil_begin[cluster], walls);
    if (walls != inner) sweep.template add_blocks<Neighbour::dummy>(walls, inner);
    if constexpr (is_any_summed(List{}, Set, Neighbour::inner)) {
      if (inner != last) sweep.template add_blocks<Neighbour::inner>(inner, last);
    }
    sweep.store();
  }
}

}  // namespace scarp::kernels
