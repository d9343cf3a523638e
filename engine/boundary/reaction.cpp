// SPDX-License-Identifier: BSD-3-Clause
/// Forces on the walls, summed only when asked for.
#include "engine/boundary/boundary.hpp"

#include "engine/state.hpp"

namespace scarp {
namespace {

/// Momentum per time that all pairs give to the soil; pairs of soil particles cancel.
Vec3 total_force(const State& state, const kernels::PairSweepView<double>& view,
                 NarrowRecords& narrow) {
  Vec3 sum{};
  sweep_force_with(state, state.neighbours.lists.active_clusters(), view, narrow);
  for (const ParticleGroup& group : state.particles.groups()) {
    for (std::size_t a = 0; a < static_cast<std::size_t>(state.scene.dimension); ++a) {
      const double* acceleration =
          view.output[output_place(Field::acceleration) + static_cast<int>(a)];
      double part = 0.0;
      for (std::int64_t k = group.first; k < group.end(); ++k) part += acceleration[k];
      sum[a] += group.mass * part;
    }
  }
  return sum;
}

}  // namespace

/// What a wall gives to the soil is the difference of two force sweeps: of the step's records, and
/// of a copy in which the volumes of the wall's dummies and images are zero. The reaction is minus
/// that, and what the wall's faces held off in the last step.
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
  const Vec3 with_all = total_force(state, view, narrow);
  const Boundary& boundary = state.boundary;
  const RecordLayout& layout = state.sweep.records.layout();
  const double* const records = view.records;
  for (std::size_t w = 0; w < reactions.size(); ++w) {
    if (!boundary.stands[w]) continue;
    reactions[w].force = boundary.hold_force[w];
    AlignedVector<double> masked(records, records + layout.records() * kernels::record_size);
    bool any = false;
    const auto mask = [&](std::int64_t record) {
      masked[static_cast<std::size_t>(record * kernels::record_size + kernels::record_volume)] =
          0.0;
      any = true;
    };
    for (std::int64_t k = 0; k < boundary.walls.count(); ++k) {
      if (boundary.walls.wall_of(k) == w) mask(layout[Role::dummy].first + k);
    }
    for (std::int64_t k = 0; k < boundary.images.count(); ++k) {
      if (boundary.images.wall_of(k) == w) mask(layout[Role::image].first + k);
    }
    if (!any) continue;
    view.records = masked.data();
    const Vec3 without = total_force(state, view, narrow);
    for (std::size_t a = 0; a < 3; ++a) reactions[w].force[a] += without[a] - with_all[a];
  }
  std::vector<Vec3> forces;
  for (const WallReaction& reaction : reactions) forces.push_back(reaction.force);
  state.reduction->sum_each(forces);
  for (std::size_t w = 0; w < reactions.size(); ++w) reactions[w].force = forces[w];
  return reactions;
}

}  // namespace scarp
