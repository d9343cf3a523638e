// SPDX-License-Identifier: BSD-3-Clause
/// Forces on the walls, summed only when asked for.
#include <algorithm>

#include "engine/boundary/boundary.hpp"
#include "engine/parallel.hpp"
#include "engine/state.hpp"

namespace scarp {
namespace {

constexpr std::int64_t clusters_per_chunk = 64;

/// The wall that a record is a dummy or an image of; none: the record is soil or padding.
std::size_t wall_of(const State& state, std::int64_t record) {
  const RecordLayout& layout = state.sweep.records.layout();
  const auto within = [&](Role role) {
    return record >= layout[role].first && record < layout[role].end();
  };
  const Boundary& boundary = state.boundary;
  if (within(Role::dummy)) {
    return boundary.walls.wall_of(record - layout[Role::dummy].first);
  }
  return within(Role::image) ? boundary.images.wall_of(record - layout[Role::image].first)
                             : no_wall;
}

/// Calls visit(wall) for each wall that a cluster has for a neighbour, perhaps more than once.
template <class Visit>
void each_wall_beside(const State& state, std::int64_t cluster, const Visit& visit) {
  const kernels::NeighbourView lists = state.neighbours.lists.view();
  const bool images = state.boundary.images.count() > 0;
  const std::int64_t end = lists.wall_end[cluster];
  for (std::int64_t block = images ? lists.soil_begin[cluster] : lists.wall_begin[cluster];
       block < end; ++block) {
    for (std::int64_t k = 0; k < kernels::entry_block; ++k) {
      const std::uint16_t place = lists.place[block * kernels::entry_block + k];
      if (place == kernels::no_neighbour) continue;
      const std::size_t wall = wall_of(state, lists.page[block] + std::int64_t{place});
      if (wall != no_wall) visit(wall);
    }
  }
}

using ClustersByWall = std::vector<std::vector<std::int32_t>>;

/// Clusters of soil beside each wall.
ClustersByWall clusters_beside_walls(const State& state) {
  const auto active = state.neighbours.lists.active_clusters();
  const ClustersByWall none(state.scene.walls.size());
  return parallel_reduce(
      state.threads, std::ssize(active), clusters_per_chunk, none,
      [&](std::int64_t begin, std::int64_t end) {
        ClustersByWall found = none;
        for (const std::int32_t cluster : active.subspan(static_cast<std::size_t>(begin),
                                                         static_cast<std::size_t>(end - begin))) {
          each_wall_beside(state, cluster, [&](std::size_t wall) {
            if (found[wall].empty() || found[wall].back() != cluster)
              found[wall].push_back(cluster);
          });
        }
        return found;
      },
      [](ClustersByWall& all, const ClustersByWall& part) {
        for (std::size_t w = 0; w < all.size(); ++w)
          all[w].insert(all[w].end(), part[w].begin(), part[w].end());
      });
}

/// Momentum per time that all pairs give to the soil of these clusters.
Vec3 total_force(const State& state, std::span<const std::int32_t> clusters,
                 const kernels::PairSweepView<double>& view, NarrowRecords& narrow) {
  Vec3 sum{};
  sweep_force_with(state, clusters, view, narrow);
  const std::int64_t size = state.kernels.cluster_size;
  for (const ParticleGroup& group : state.particles.groups()) {
    for (std::size_t a = 0; a < static_cast<std::size_t>(state.scene.dimension); ++a) {
      const double* acceleration =
          view.output[output_place(Field::acceleration) + static_cast<int>(a)];
      double part = 0.0;
      for (const std::int32_t cluster : clusters) {
        const std::int64_t first = std::max(cluster * size, group.first),
                           end = std::min((cluster + 1) * size, group.end());
        for (std::int64_t k = first; k < end; ++k) part += acceleration[k];
      }
      sum[a] += group.inertia() * part;
    }
  }
  return sum;
}

/// Records of which one wall's alone have a volume: no other pair gives a force. They are copied
/// only where they are needed.
class OneWall {
 public:
  explicit OneWall(const State& state) : state_(state) {}

  /// Puts the records into the view. Pre: `leave` is called before the next wall.
  void enter(std::size_t wall, kernels::PairSweepView<double>& view) {
    const Records& records = state_.sweep.records;
    if (masked_.empty()) {
      masked_.assign(records.records(),
                     records.records() + records.layout().records() * kernels::record_size);
      for (std::int64_t k = 0; k < records.layout().records(); ++k) volume(k) = 0.0;
    }
    each(wall, [&](std::int64_t record) {
      volume(record) = records.records()[record * kernels::record_size + kernels::record_volume];
    });
    view.records = masked_.data();
  }
  void leave(std::size_t wall) {
    if (masked_.empty()) return;
    each(wall, [&](std::int64_t record) { volume(record) = 0.0; });
  }

 private:
  double& volume(std::int64_t record) {
    return masked_[static_cast<std::size_t>(record * kernels::record_size +
                                            kernels::record_volume)];
  }
  template <class Visit>
  void each(std::size_t wall, const Visit& visit) const {
    for (const Role role : {Role::dummy, Role::image}) {
      const RecordRange& range = state_.sweep.records.layout()[role];
      for (std::int64_t record = range.first; record < range.end(); ++record) {
        if (wall_of(state_, record) == wall) visit(record);
      }
    }
  }

  const State& state_;
  AlignedVector<double> masked_;
};

}  // namespace

/// What a wall gives to the soil beside it is a force sweep over the pairs with its dummies and
/// images alone. The reaction is minus that, and what the wall's faces held off in the last step.
std::vector<WallReaction> wall_reactions(const State& state) {
  std::vector<WallReaction> reactions;
  for (const Wall& wall : state.scene.walls) reactions.push_back({wall.name, {}});
  if (!state.neighbours.valid || reactions.empty()) return reactions;
  AlignedVector<double> acceleration[3];
  NarrowRecords narrow;
  kernels::PairSweepView<double> view = sweep_input_view(state);
  // As in the step's own sweep; second lines of zeros leave the force as it is.
  state.sweep.records.fill(view, state.sweep.records.has_second());
  double** out = view.output + output_place(Field::acceleration);
  for (std::size_t a = 0; a < 3; ++a) {
    acceleration[a].assign(static_cast<std::size_t>(state.particles.slots()), 0.0);
    out[a] = acceleration[a].data();
  }
  const ClustersByWall beside = clusters_beside_walls(state);
  const auto stands_beside = [&](std::size_t w) {
    return state.boundary.stands[w] && !beside[w].empty();
  };
  std::size_t rough = 0;
  for (std::size_t w = 0; w < reactions.size(); ++w)
    rough += stands_beside(w) && state.scene.walls[w].kind == WallKind::no_slip ? 1 : 0;
  OneWall records(state);
  for (std::size_t w = 0; w < reactions.size(); ++w) {
    if (!state.boundary.stands[w]) continue;
    reactions[w].force = state.boundary.hold_force[w];
    if (!stands_beside(w)) continue;
    kernels::PairSweepView<double> pairs = view;
    const bool smooth = state.scene.walls[w].kind == WallKind::free_slip;
    // Dummies have their own part of the lists.
    if (!smooth) pairs.neighbours.soil_begin = pairs.neighbours.wall_begin;
    if (smooth || rough > 1) records.enter(w, pairs);
    const Vec3 force = total_force(state, beside[w], pairs, narrow);
    records.leave(w);
    for (std::size_t a = 0; a < 3; ++a) reactions[w].force[a] -= force[a];
  }
  std::vector<Vec3> forces;
  for (const WallReaction& reaction : reactions) forces.push_back(reaction.force);
  state.reduction->sum_each(forces);
  for (std::size_t w = 0; w < reactions.size(); ++w) reactions[w].force = forces[w];
  return reactions;
}

}  // namespace scarp
