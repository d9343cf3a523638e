// SPDX-License-Identifier: BSD-3-Clause
/// Neighbour lists of clusters of consecutive particles, with a skin so that they outlive many
/// steps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/cells/cell_grid.hpp"
#include "engine/neighbours/neighbour_blocks.hpp"
#include "engine/particles/record_layout.hpp"
#include "kernels/isa/kernel_table.hpp"
#include "kernels/particle_view.hpp"

namespace scarp {

/// Points that are searched for neighbours: what they are, their cells, coordinates, and the index
/// that their first slot has among the records of the sweep.
struct ParticleSource {
  Role role = Role::owned;
  const CellGrid* grid = nullptr;
  PointSpan points;
  std::int64_t first_record = 0;
  std::vector<std::int64_t> fast = {};  ///< slots whose reach is wider, ascending
};

/// Lists of `ranges` of points (clusters never cross a range): soil and images in the order of the
/// sources, then dummies, then inner points, the whole followed by two empty blocks.
class NeighbourLists {
 public:
  struct Input {
    PointSpan points;  ///< of the clusters' particles
    std::span<const SlotRange>
        ranges;              ///< valid slots; ranges start at multiples of the cluster size
    std::int64_t slots = 0;  ///< with padding
    std::span<const ParticleSource> sources;
    std::int64_t far_record = 0;
    double reach = 0.0;                       ///< support plus skin [m]
    std::span<const std::int64_t> fast = {};  ///< slots of the points whose reach is wider
    double more = 0.0;                        ///< by this [m]
    int dimension = 3;
    int cluster_size = 1;  ///< particles per list
  };

  void build(int threads, const kernels::KernelTable& kernels, const Input& input);

  kernels::NeighbourView view() const {
    return {blocks_.page().data(), blocks_.place().data(), soil_begin_.data(),
            wall_begin_.data(),    inner_begin_.data(),    far_record_};
  }
  std::int64_t clusters() const { return static_cast<std::int64_t>(wall_begin_.size()); }
  /// Clusters that have neighbours at all.
  std::span<const std::int32_t> active_clusters() const { return active_; }
  /// Of all lists, padding included.
  std::int64_t entries() const { return blocks_.size() * kernels::entry_block; }
  std::size_t bytes() const;

 private:
  NeighbourBlocks blocks_;
  std::vector<std::int64_t> soil_begin_{0}, wall_begin_, inner_begin_;
  std::int32_t far_record_ = 0;
  RawVector<std::int32_t> active_;
};

}  // namespace scarp
