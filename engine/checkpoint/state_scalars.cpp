// SPDX-License-Identifier: BSD-3-Clause
/// One list of the single numbers of a state, for both directions.
#include "engine/checkpoint/state_scalars.hpp"

#include <cstdint>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "engine/checkpoint/finite_numbers.hpp"
#include "engine/errors.hpp"
#include "engine/state.hpp"

namespace scarp {
namespace {

/// Values that a scalar may have.
struct Range {
  double least, most;
};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range any{-infinity, infinity}, not_negative{0.0, infinity};
/// Halved a few times by retries; programs may choose others.
constexpr Range step_factors{1e-9, 1e3};

class Taker {
 public:
  explicit Taker(Snapshot& out) : out_(out) {}
  void number(const char* name, const char* unit, double value, Range = any) {
    out_.add(name, unit, {value});
  }
  template <class T>
  void integer(const char* name, T value, std::int64_t = 0) {
    out_.add(name, std::vector<std::int64_t>{static_cast<std::int64_t>(value)});
  }
  void count(const char* name, std::uint64_t of_part, Reduction& parts) {
    integer(name, parts.sum_of(static_cast<double>(of_part)));
  }

 private:
  Snapshot& out_;
};

class Putter {
 public:
  explicit Putter(const Snapshot& from) : from_(from) {}
  void number(const char* name, const char*, double& value, Range range = any) {
    value = finite_numbers(from_, name, 1).front();
    if (value < range.least || value > range.most) refuse(name, value);
  }
  template <class T>
  void integer(const char* name, T& value, std::int64_t most = most_of<T>) {
    const std::int64_t stored = from_.integers(name, 1).front();
    if (stored < 0 || stored > most) refuse(name, static_cast<double>(stored));
    value = static_cast<T>(stored);
  }
  void count(const char* name, std::uint64_t& of_part, const Reduction& parts) {
    integer(name, of_part);
    if (!parts.leads()) of_part = 0;
  }

 private:
  template <class T>
  static constexpr std::int64_t most_of = std::is_same_v<T, bool> ? 1
                                          : std::is_same_v<T, int>
                                              ? std::numeric_limits<int>::max()
                                              : std::numeric_limits<std::int64_t>::max();
  [[noreturn]] static void refuse(const char* name, double value) {
    throw CheckpointError(fmt::format("'{}' is {:g}, which no run leaves.", name, value));
  }

  const Snapshot& from_;
};

/// The scalars of a state. `state` is const for a Taker.
template <class Archive, class AnyState>
void exchange(Archive& a, AnyState& state) {
  a.integer("clock/step", state.report.step);
  a.number("clock/time", "s", state.report.time, not_negative);
  a.number("clock/stage_time", "s", state.stage.time, not_negative);
  a.number("clock/time_step", "s", state.clock.time_step, not_negative);
  a.number("clock/previous_time_step", "s", state.clock.previous_time_step, not_negative);
  a.number("clock/growth_base", "s", state.clock.growth_base, not_negative);
  a.integer("clock/since_restart", state.clock.since_restart);
  a.integer("clock/restart", state.clock.restart);
  a.number("clock/step_factor", "", state.clock.step_factor, step_factors);
  a.number("report/stage_time", "s", state.report.stage_time, not_negative);
  a.number("report/time_step", "s", state.report.time_step, not_negative);
  a.integer("report/limit", state.report.limit, std::size(step_limit_names) - 1);
  a.integer("report/signal_material", state.report.signal_material,
            static_cast<std::int64_t>(state.scene.materials.size()) - 1);
  a.number("report/max_velocity", "m/s", state.report.max_velocity, not_negative);
  a.integer("stage/index", state.stage.index,
            static_cast<std::int64_t>(state.scene.stages.size()) - 1);
  a.integer("stage/started", state.stage.started);
  a.integer("stage/ended", state.stage.ended);
  a.integer("stage/reached_rest", state.stage.reached_rest);
  a.number("stage/calm_since", "s", state.stage.calm_since);
  a.number("stage/damping", "1/s", state.stage.damping, not_negative);
  a.number("stage/rest_window", "s", state.stage.rest_window, not_negative);
  a.number("stage/start_speed", "m/s", state.stage.start_speed, not_negative);
  a.integer("lists/valid", state.neighbours.valid);
  a.integer("lists/rebuilds", state.neighbours.rebuilds);
  a.number("lists/walls_moved", "m", state.boundary.moved, not_negative);
  a.count("counts/density_bounds", state.density_bounds, *state.reduction);
  a.count("counts/face_holds", state.boundary.holds, *state.reduction);
  for (std::size_t k = 0; k < std::size(step_limit_names); ++k)
    a.integer(fmt::format("counts/steps_by_{}", step_limit_names[k]).c_str(),
              state.limits.counts[k]);
  if (soil_may_sleep(state.scene)) {
    a.number("sleep/lasting", "m/s2", state.sleep.bounds.lasting, not_negative);
    a.number("sleep/acceleration", "m/s2", state.sleep.bounds.acceleration, not_negative);
    a.number("sleep/speed", "m/s", state.sleep.bounds.speed, not_negative);
    a.number("sleep/window", "s", state.sleep.bounds.window, not_negative);
    a.number("sleep/moved", "m", state.sleep.moved, not_negative);
    a.number("sleep/kinetic", "J", state.sleep.kinetic, not_negative);
    a.integer("sleep/wake_due", state.sleep.wake_due);
  }
  auto& ledger = state.ledger;
  const auto powers = [&a](const char* const(&names)[6], const char* unit, auto& p) {
    a.number(names[0], unit, p.stress);
    a.number(names[1], unit, p.viscous);
    a.number(names[2], unit, p.artificial_stress);
    a.number(names[3], unit, p.damping);
    a.number(names[4], unit, p.wall);
    a.number(names[5], unit, p.hold);
  };
  powers({"energy/work_stress", "energy/work_viscous", "energy/work_artificial_stress",
          "energy/work_damping", "energy/work_wall", "energy/work_hold"},
         "J", ledger.work);
  powers({"energy/power_stress", "energy/power_viscous", "energy/power_artificial_stress",
          "energy/power_damping", "energy/power_wall", "energy/power_hold"},
         "W", ledger.last_powers);
  a.number("energy/last_time", "s", ledger.last_time);
  a.integer("energy/last_step", ledger.last_step);
  a.number("energy/start_kinetic", "J", ledger.start.kinetic);
  a.number("energy/start_potential", "J", ledger.start.potential);
  a.number("energy/start_elastic", "J", ledger.start.elastic);
  a.number("energy/start_plastic", "J", ledger.start.plastic);
  a.number("energy/start_diffusion", "J", ledger.start.diffusion);
  a.number("energy/start_stress_work", "J", ledger.stress_work_start);
  a.number("energy/hooks_net", "J", ledger.hooks.net);
  a.number("energy/hooks_sum", "J", ledger.hooks.sum, not_negative);
  a.number("energy/hooks_speed", "m/s", ledger.hooks.speed, not_negative);
}

}  // namespace

void take_scalars(Snapshot& out, const State& state) {
  Taker taker(out);
  exchange(taker, state);
}

void put_scalars(const Snapshot& from, State& state) {
  Putter putter(from);
  exchange(putter, state);
}

}  // namespace scarp
