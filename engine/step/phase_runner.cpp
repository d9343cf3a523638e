// SPDX-License-Identifier: BSD-3-Clause
/// Phases one after the other.
#include "engine/step/phase_runner.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "engine/energy/hook_work.hpp"
#include "engine/errors.hpp"
#include "engine/state.hpp"

namespace scarp {

PhaseRunner::PhaseRunner(Integrator integrator, bool corrects_forces)
    : phases_(phases_of(integrator, corrects_forces)),
      start_seconds_(phases_.stage_start.size()),
      step_seconds_(phases_.step.size()) {}

namespace {

/// A phase that the scene does not ask for changes nothing.
bool acts(const State& state, const Phase& phase) {
  return phase.run != scarp::update_sleep || soil_may_sleep(state.scene);
}

}  // namespace

/// At least 1: what only the start of a stage has.
double PhaseRunner::times_in_a_step(std::string_view phase) const {
  const auto times = std::count_if(phases_.step.begin(), phases_.step.end(),
                                   [phase](const Phase& one) { return one.name == phase; });
  return std::max(1.0, static_cast<double>(times));
}

void PhaseRunner::call_hooks(State& state, const Phase& phase, When when) const {
  for (const Hook& hook : hooks_) {
    if (hook.when != when || hook.phase != phase.name) continue;
    HookMeter meter(state, 1.0 / times_in_a_step(hook.phase));
    PhaseView view(state, phase, when, meter);
    state.changed = state.changed | phase.reads | phase.writes;
    hook.call(view);
    meter.enter();
  }
}

/// Adds what each phase took to `seconds` and returns the sum [s].
double PhaseRunner::run(State& state, PhaseList list, std::vector<double>& seconds) const {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  Clock::time_point before = began;
  for (std::size_t k = 0; k < list.size(); ++k) {
    call_hooks(state, list[k], When::before);
    // Lists are built of soil that has been dealt, with ghosts of its own.
    if (!list[k].writes.has(Part::lists) && acts(state, list[k]))
      state.changed = state.changed | list[k].writes;
    list[k].run(state);
    call_hooks(state, list[k], When::after);
    const Clock::time_point after = Clock::now();
    seconds[k] += std::chrono::duration<double>(after - before).count();
    before = after;
  }
  return std::chrono::duration<double>(before - began).count();
}

void PhaseRunner::step(State& state) {
  if (!state.stage.started || state.stage.ended) run(state, phases_.stage_start, start_seconds_);
  if (state.sleep.wake_due) wake_all(state);
  const std::uint64_t rebuilds = state.neighbours.rebuilds;
  state.threads = state.team.threads();
  const double seconds = run(state, phases_.step, step_seconds_);
  state.team.took(seconds, state.neighbours.rebuilds != rebuilds);
}

void PhaseRunner::renew(State& state) const {
  state.clock.restart = true;
  state.changed = ghost_fields;
  wake_all(state);
  if (!state.stage.started) return;  // the start of the stage does it
  state.stage.start_speed = std::max(state.stage.start_speed, fastest_soil(state));
  std::vector<double> seconds(phases_.renewal.size());
  run(state, phases_.renewal, seconds);
}

void PhaseRunner::add(std::string_view phase, When when, PhaseHook hook) {
  if (!hook) throw Error(fmt::format("on_phase('{}'): the hook is empty. Try a function.", phase));
  const std::vector<PhaseTime> known = times();
  const auto is_it = [phase](const PhaseTime& one) { return one.phase == phase; };
  if (std::none_of(known.begin(), known.end(), is_it)) {
    std::string names;
    for (const PhaseTime& one : known) names += (names.empty() ? "" : ", ") + one.phase;
    throw Error(
        fmt::format("on_phase('{}'): this run has no such phase; there are {}.", phase, names));
  }
  hooks_.push_back({std::string(phase), when, std::move(hook)});
}

std::vector<PhaseTime> PhaseRunner::times() const {
  std::vector<PhaseTime> times;
  const auto add = [&times](PhaseList list, const std::vector<double>& seconds) {
    for (std::size_t k = 0; k < list.size(); ++k) {
      const auto known = std::find_if(times.begin(), times.end(), [&](const PhaseTime& time) {
        return time.phase == list[k].name;
      });
      if (known == times.end()) {
        times.push_back({list[k].name, seconds[k]});
      } else {
        known->seconds += seconds[k];
      }
    }
  };
  add(phases_.step, step_seconds_);
  add(phases_.stage_start, start_seconds_);
  return times;
}

}  // namespace scarp
