// SPDX-License-Identifier: BSD-3-Clause
/// Bounds on speed, density, stress and energy.
#include "engine/watch/watch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "engine/parallel.hpp"
#include "engine/state.hpp"

namespace scarp {
namespace {

/// The widest that the bounds of a scene may be (`density_minimum`, `density_maximum`).
constexpr double least_density = 0.01, most_density = 10.0;

/// Over the speeds that the soil has a reason for; hard grains hit by a heavy block leave with up
/// to twice its speed.
constexpr double speed_margin = 2.0;

constexpr const char* causes =
    "soil too soft for its load, walls that squeeze or throw it, or a time step too long for the "
    "stiffness; from here they look alike";
constexpr const char* remedies = "a stiffer soil, a finer spacing or slower walls may help";

double value_of(const State& state, Field field, int component, std::int64_t slot) {
  const double* array = state.particles.component(field, component);
  return array != nullptr ? array[slot] : 0.0;
}

double speed_squared(const State& state, std::int64_t slot) {
  double square = 0.0;
  for (int a = 0; a < state.scene.dimension; ++a) {
    const double v = state.particles.component(Field::velocity, a)[slot];
    square += v * v;
  }
  return square;
}

/// Below 0 in a part without soil.
std::int64_t fastest_slot(const State& state) {
  struct Fastest {
    double square = -1.0;
    std::int64_t slot = -1;
    void look_at(const Fastest& other) {
      if (!(other.square <= square)) *this = other;
    }
  } fastest;
  for (const ParticleGroup& group : state.particles.groups()) {
    fastest.look_at(parallel_reduce(
        state.threads, group.count, particle_chunk, Fastest{},
        [&](std::int64_t begin, std::int64_t end) {
          Fastest here;
          for (std::int64_t k = group.first + begin; k < group.first + end; ++k)
            here.look_at({speed_squared(state, k), k});
          return here;
        },
        [](Fastest& total, const Fastest& part) { total.look_at(part); }));
  }
  return fastest.slot;
}

/// What waves, the start of the stage, its walls and hooks give a reason for.
double allowed_speed(const State& state, double by_hooks) {
  return speed_margin * (state.limits.sound_speed + state.stage.start_speed + by_hooks);
}

/// Beyond the allowed speed only a fall explains more: its own, or that of soil which pushes it.
std::optional<Instability> too_fast(const State& state) {
  const std::int64_t slot = fastest_slot(state);
  const Vec3& g = state.scene.gravity;
  const double height = std::hypot(g[0], g[1], g[2]) * soil_height(state);
  const double by_hooks = state.reduction->maximum_of(state.ledger.hooks.speed);
  if (slot < 0) return {};
  double fall = 0.0;  // g . u, since the last reset
  for (int a = 0; a < state.scene.dimension; ++a) {
    fall += state.scene.gravity[static_cast<std::size_t>(a)] *
            (value_of(state, Field::position, a, slot) -
             value_of(state, Field::reference_position, a, slot));
  }
  Instability found = at_particle(state, slot);
  found.field = "speed";
  found.unit = "m/s";
  found.value = std::sqrt(speed_squared(state, slot));
  found.limit = allowed_speed(state, by_hooks) + std::sqrt(2.0 * (std::max(fall, 0.0) + height));
  if (found.value <= found.limit) return {};
  found.cause = causes;
  found.advice = advice_after_step_test(remedies);
  return found;
}

/// The first particle for which bad(material's reference density, slot) holds, or -1.
template <class Bad>
std::int64_t first_slot(const State& state, Bad&& bad) {
  for (const ParticleGroup& group : state.particles.groups()) {
    const double reference = state.scene.materials[group.material].density;
    const auto look = [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t k = group.first + begin; k < group.first + end; ++k) {
        if (bad(reference, k)) return k;
      }
      return std::int64_t{-1};
    };
    const std::int64_t slot = parallel_reduce(
        state.threads, group.count, particle_chunk, std::int64_t{-1}, look,
        [](std::int64_t& total, std::int64_t part) { total = total < 0 ? part : total; });
    if (slot >= 0) return slot;
  }
  return -1;
}

/// A density that is a number, but out of the range of soil.
std::optional<Instability> torn_or_crushed(const State& state) {
  const double* density = state.particles.component(Field::density);
  const std::int64_t slot = first_slot(state, [&](double reference, std::int64_t k) {
    return density[k] < least_density * reference ||
           (density[k] > most_density * reference && std::isfinite(density[k]));
  });
  if (slot < 0) return {};
  const double reference = state.scene.materials[state.particles.group_of(slot).material].density;
  Instability found = at_particle(state, slot);
  found.field = "density";
  found.unit = "kg/m3";
  found.value = density[slot];
  found.limit = (found.value > reference ? most_density : least_density) * reference;
  found.cause = std::string("soil torn apart or crushed: ") + causes;
  found.advice = advice_after_step_test(remedies) + "; gradient_correction = true bounds density";
  return found;
}

std::optional<Instability> not_finite_at_a_look(const State& state) {
  std::vector<const double*> looked_at;
  for (const FieldRow& field : state.particles.rows()) {
    if (field.check != Check::each_look) continue;
    for (int c = 0; c < component_count(field.rank); ++c) {
      if (const double* array = state.particles.component(field.field, c))
        looked_at.push_back(array);
    }
  }
  const std::int64_t slot = first_slot(state, [&](double, std::int64_t k) {
    double sum = 0.0;
    for (const double* array : looked_at) sum += array[k];
    return !std::isfinite(sum);
  });
  if (slot < 0) return {};
  return not_finite(state, slot);
}

/// But for the work of hooks, kinetic, potential and elastic energy may only fall in a stage whose
/// walls rest. What they may exceed their start by is what the stage has had to spend: its start,
/// what has fallen, and what hooks gave or took, whose work is known to first order in the step.
std::optional<Instability> energy_from_nothing(const State& state) {
  for (const Vec3& v : state.boundary.velocity) {
    if (v != Vec3{}) return {};
  }
  const EnergyBalance& start = state.ledger.start;
  const EnergyBalance now = energy_balance(state);
  const double gain = now.kinetic - start.kinetic + now.potential + now.elastic - now.hooks;
  double inertia = state.particles.inertia(), by_hooks = state.ledger.hooks.sum;
  state.reduction->sum_each({&inertia, &by_hooks});
  // Without weight, speed and stress round-off is all there is: a thousandth of the wave speed.
  const double slow = 1e-3 * state.limits.sound_speed;
  const double spent = start.kinetic + start.elastic + std::max(-now.potential, 0.0) + by_hooks +
                       0.5 * inertia * slow * slow;
  const std::int64_t likeliest = fastest_slot(state);
  if (gain <= spent || likeliest < 0) return {};
  Instability found = at_particle(state, likeliest);
  found.field = "energy gained by all soil";
  found.unit = state.scene.dimension == 2 ? "J/m" : "J";
  found.value = gain;
  found.limit = spent;
  found.cause = causes;
  found.advice = advice_after_step_test(remedies);
  return found;
}

}  // namespace

std::string advice_after_step_test(const char* then) {
  return fmt::format(
      "half the cfl first, as `retry` under [run] does by itself: if it stops at the same time "
      "again, the time step is not the cause, and {}",
      then);
}

Instability at_particle(const State& state, std::int64_t slot) {
  Instability found;
  found.step = state.report.step + 1;
  found.time = state.report.time;
  found.stage = state.scene.stages[state.stage.index].name;
  found.particle = state.particles.ids()[static_cast<std::size_t>(slot)];
  for (int a = 0; a < state.scene.dimension; ++a)
    found.position[static_cast<std::size_t>(a)] = value_of(state, Field::position, a, slot);
  return found;
}

Instability not_finite(const State& state, std::int64_t slot) {
  if (auto reason = torn_or_crushed(state)) return *reason;  // it spoils its neighbours
  Instability found = at_particle(state, slot);
  found.limit = std::numeric_limits<double>::quiet_NaN();
  const auto look = [&](Check due) {
    for (const FieldRow& field : state.particles.rows()) {
      if (field.check != due) continue;
      for (int c = 0; found.field.empty() && c < component_count(field.rank); ++c) {
        const double value = value_of(state, field.field, c, slot);
        // The largest square that a step is chosen by is 1e300.
        if (std::abs(value) < 1e150 && !(field.field == Field::density && value <= 0.0)) continue;
        found.field = field.name;
        found.unit = field.unit;
        found.value = value;
      }
    }
  };
  look(Check::each_look);  // a stress that is no number makes the acceleration none
  look(Check::each_step);
  found.cause =
      "particles that overlap or meet a gap between walls, or a time step too long for the "
      "stiffness; from here they look alike";
  found.advice = advice_after_step_test(remedies);
  return found;
}

std::optional<Instability> inspect(const State& state) {
  if (auto found = torn_or_crushed(state)) return found;
  if (auto found = not_finite_at_a_look(state)) return found;
  if (auto found = too_fast(state)) return found;
  return energy_from_nothing(state);
}

void watch(State& state) {
  std::optional<Instability> found;
  // Without what hooks gave, which other parts may not know: `too_fast` asks.
  if (state.report.max_velocity > allowed_speed(state, 0.0)) found = too_fast(state);
  if (!found && (state.report.step + 1) % steps_per_look == 0) found = inspect(state);
  if (found) throw SimulationInstability(*found);
}

}  // namespace scarp
