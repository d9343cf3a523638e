// SPDX-License-Identifier: BSD-3-Clause
/// Chooses the time step of a step from the rates at hand.
#include <algorithm>
#include <cmath>

#include "engine/errors.hpp"
#include "engine/integrate/time_step.hpp"
#include "engine/state.hpp"
#include "engine/watch/watch.hpp"

namespace scarp {
namespace {

/// A step may be longer than the one before by this factor at most: Verlet leaps over two steps.
constexpr double largest_growth = 1.1;

}  // namespace

void choose_time_step(State& state) {
  StateExtremes extremes = find_extremes(state.threads, state.particles, state.sleep.awake,
                                         state.scaling, state.scene.gravity, state.stage.damping);
  if (extremes.bad_slot >= 0) throw SimulationInstability(not_finite(state, extremes.bad_slot));
  join(extremes, *state.reduction);
  auto [dt, limit] = admissible_step(extremes, state.limits.damping_rates, state.smoothing_length,
                                     state.scene.numerics.cfl * state.clock.step_factor);
  StepClock& clock = state.clock;
  if (!(extremes.signal_speed > 0.0)) dt = clock.growth_base;  // nothing moves that could bound it
  if (clock.growth_base > 0.0 && dt > largest_growth * clock.growth_base) {
    dt = largest_growth * clock.growth_base;
    limit = StepLimit::growth;
  }
  clock.growth_base = dt;
  const std::optional<double> duration = state.scene.stages[state.stage.index].duration;
  const double left = duration.value_or(0.0) - state.stage.time;
  if (duration && dt >= left) {
    dt = left;
    limit = StepLimit::stage_end;
  }
  clock.time_step = dt;
  std::fill(state.boundary.hold_force.begin(), state.boundary.hold_force.end(),
            Vec3{});  // of the step before
  state.report.limit = limit;
  state.report.time_step = dt;
  state.report.max_velocity =
      state.lost.particles > 0 ? fastest_soil(state) : std::sqrt(extremes.speed_squared);
  state.report.signal_material = extremes.signal_material;
}

}  // namespace scarp
