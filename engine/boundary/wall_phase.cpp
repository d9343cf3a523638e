// SPDX-License-Identifier: BSD-3-Clause
/// The walls' phase of a step: dummies into the records, velocity and stress from the soil.
#include "engine/boundary/boundary.hpp"

#include <algorithm>
#include <cmath>

#include "engine/state.hpp"

namespace scarp {
namespace {

WallMaterial wall_material(const State& state) {
  const Material& material = state.scene.materials[state.boundary.material];
  const double volume = std::pow(state.particles.largest_spacing(), state.scene.dimension);
  return {material.density, material.sound_speed(), volume * state.scaling.gradient_factor,
          state.scaling.inverse_smoothing_length};
}

kernels::WallSums sums_of(const State& state) {
  if (!state.kernels.corrects_forces()) return kernels::WallSums::extrapolation;
  return state.sweep.records.stress_form() == StressForm::corrected
             ? kernels::WallSums::corrected_stress
             : kernels::WallSums::gradient;
}

}  // namespace

void move_walls(State& state, double dt) {
  for (std::size_t w = 0; w < state.scene.walls.size(); ++w) {
    const Vec3& v = state.boundary.velocity[w];
    if (v == Vec3{}) continue;
    const Vec3 step{v[0] * dt, v[1] * dt, v[2] * dt};
    for (std::size_t a = 0; a < 3; ++a) state.boundary.offset[w][a] += step[a];
    state.boundary.walls.move(state.threads, w, step);
    state.boundary.moved += std::hypot(step[0], step[1], step[2]);
  }
}

bool mirrors_move(const Scene& scene) {
  return std::any_of(scene.walls.begin(), scene.walls.end(), [](const Wall& wall) {
    return wall.kind == WallKind::free_slip && wall.velocity != Vec3{};
  });
}

void extrapolate_walls(State& state) {
  if (state.boundary.walls.count() == 0) return;
  kernels::WallSweepView<double> view{};
  view.records = state.sweep.records.records();
  view.extra = state.sweep.records.extra_lines();
  view.first_wall = state.sweep.records.layout()[Role::dummy].first;
  view.neighbours = state.neighbours.wall_lists.view();
  view.smoothing = state.sweep.constants.smoothing;
  for (std::size_t a = 0; a < 3; ++a)
    view.gravity[a] = state.scene.gravity[a] * state.smoothing_length;
  state.boundary.walls.take_sums(sums_of(state), state.threads, *state.kernels.table,
                                 state.scene.dimension, walls_summed(state), view,
                                 wall_material(state), state.boundary.velocity,
                                 state.sweep.records);
}

}  // namespace scarp
