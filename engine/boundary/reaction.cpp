// SPDX-License-Identifier: BSD-3-Clause
/// Forces on the walls, summed only when asked for.
#include <utility>

#include "engine/state.hpp"

namespace scarp {
namespace {

/// Momentum per time that all pairs give to the soil; pairs of soil particles cancel.
Vec3 total_force(State& state, const kernels::PairSweepView<double>& view) {
  Vec3 sum{};
  sweep_force_with(state, view);
  for (const ParticleGroup& group : state.particles.groups()) {
    for (std::size_t a = 0; a < static_cast<std::size_t>(state.scene.dimension); ++a) {
      double part = 0.0;
      for (std::int64_t k = group.first; k < group.end(); ++k) part += view.acceleration[a][k];
      sum[a] += state.scaling.mass[group.material] * part;
    }
  }
  return sum;
}

}  // namespace

/// A force sweep with the wall's dummies and images against one with their volumes set to zero: the
/// difference is what the wall gives to the soil, the reaction minus that. What a face held off in
/// the last step comes on top.
std::vector<WallReaction> wall_reactions(State& state) {
  std::vector<WallReaction> reactions;
  for (const Wall& wall : state.scene.walls) reactions.push_back({wall.name, {}});
  if (!state.lists_valid || reactions.empty()) return reactions;
  AlignedVector<double> acceleration[3];
  kernels::PairSweepView<double> view = sweep_view(state);
  view.approach_rate = nullptr;
  // As in the step's own sweep; empty tension records leave the force as it is.
  state.records.fill(view, state.records.has_tension_records());
  for (std::size_t a = 0; a < 3; ++a) {
    acceleration[a].assign(static_cast<std::size_t>(state.particles.slots()), 0.0);
    view.acceleration[a] = acceleration[a].data();
  }
  const Vec3 with_all = total_force(state, view);
  for (std::size_t w = 0; w < reactions.size(); ++w) {
    if (!state.wall_stands[w]) continue;
    reactions[w].force = state.hold_force[w];
    std::vector<std::pair<double*, double>> silenced;
    const auto silence = [&](std::int64_t record) {
      double& volume = state.records.record(record)[kernels::record_volume];
      silenced.emplace_back(&volume, volume);
      volume = 0.0;
    };
    for (std::int64_t k = 0; k < state.walls.count(); ++k) {
      if (state.walls.wall_of(k) == w) silence(state.records.first_wall() + k);
    }
    for (std::int64_t k = 0; k < state.images.count(); ++k) {
      if (state.images.wall_of(k) == w) silence(state.records.first_image() + k);
    }
    if (silenced.empty()) continue;
    const Vec3 without = total_force(state, view);
    for (std::size_t a = 0; a < 3; ++a) reactions[w].force[a] += without[a] - with_all[a];
    for (const auto& [volume, value] : silenced) *volume = value;
  }
  return reactions;
}

}  // namespace scarp
