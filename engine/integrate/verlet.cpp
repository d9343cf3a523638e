// SPDX-License-Identifier: BSD-3-Clause
/// Verlet scheme of the paper: every rate at step n, one sweep a step. Equation: E28, E29.
#include "engine/integrate/stress_phase.hpp"
#include "engine/parallel.hpp"
#include "engine/state.hpp"

namespace scarp {

/// Leaps from n-1 over dt_{n-1} + dt_n, and every M steps forward from n; the stress pass is fused
/// with the update of all levels.
void advance_verlet(State& state) {
  StepClock& clock = state.clock;
  const bool leaps =
      !clock.restart && clock.since_restart < state.scene.numerics.verlet_restart_interval;
  const double dt = clock.time_step;
  const double leap = leaps ? clock.previous_time_step + dt : dt;
  clock.kick = leap;
  const kernels::VerletConstants verlet{dt, leaps, state.stage.damping};
  run_stress_phase(
      state, dt, leap,
      [&](const kernels::ModelPasses& passes, const kernels::ParticleView& view,
          const kernels::StressPassConstants& constants, std::size_t begin, std::size_t end) {
        const auto dimension = static_cast<std::size_t>(state.scene.dimension - 2);
        return passes.verlet[dimension](view, constants, verlet, begin, end);
      });
  move_walls(state, dt);
  clock.since_restart = leaps ? clock.since_restart + 1 : 1;
  clock.restart = false;
  clock.previous_time_step = dt;
}

}  // namespace scarp
