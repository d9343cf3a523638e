// SPDX-License-Identifier: BSD-3-Clause
/// Kick-drift-kick scheme: velocity gradient at mid-step, force at the end. Equation: I1.
#include "engine/integrate/stress_phase.hpp"
#include "engine/particles/each_slot.hpp"
#include "engine/state.hpp"

namespace scarp {

/// Half a step of acceleration, gravity and damping, the damping on the mean of old and new
/// velocity.
void kick_half(State& state) {
  const double half = 0.5 * state.clock.time_step, damp = 0.5 * half * state.stage.damping;
  const double keep = (1.0 - damp) / (1.0 + damp), gain = half / (1.0 + damp);
  state.clock.kick = half;
  for (int a = 0; a < state.scene.dimension; ++a) {
    double* velocity = state.particles.component(Field::velocity, a);
    const double* acceleration = state.particles.component(Field::acceleration, a);
    const auto axis = static_cast<std::size_t>(a);
    each_slot(state.threads, state.sleep.awake, state.particles.slots(),
              [&](std::int64_t begin, std::int64_t end) {
                each_group(state.particles.groups(), begin, end,
                           [&](const ParticleGroup& group, std::int64_t from, std::int64_t to) {
                             const double fall = group.fall(state.scene.gravity)[axis];
                             for (std::int64_t k = from; k < to; ++k)
                               velocity[k] = keep * velocity[k] + gain * (acceleration[k] + fall);
                           });
              });
  }
}

void drift_half(State& state) {
  const double half = 0.5 * state.clock.time_step;
  for (int a = 0; a < state.scene.dimension; ++a) {
    double* position = state.particles.component(Field::position, a);
    const double* velocity = state.particles.component(Field::velocity, a);
    each_slot(state.threads, state.sleep.awake, state.particles.slots(),
              [&](std::int64_t begin, std::int64_t end) {
                for (std::int64_t k = begin; k < end; ++k) position[k] += half * velocity[k];
              });
  }
  move_walls(state, half);
}

void advance_stress(State& state) {
  const double dt = state.clock.time_step;
  run_stress_phase(
      state, dt, dt,
      [&](const kernels::ModelPasses& passes, const kernels::ParticleView& view,
          const kernels::StressPassConstants& constants, std::size_t begin, std::size_t end) {
        const auto dimension = static_cast<std::size_t>(state.scene.dimension - 2);
        return passes.stress[dimension](view, constants, begin, end);
      });
}

}  // namespace scarp
