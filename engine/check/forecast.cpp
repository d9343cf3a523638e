// SPDX-License-Identifier: BSD-3-Clause
/// Rehearsal at a coarse spacing.
#include "engine/check/forecast.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "engine/errors.hpp"
#include "engine/run/run.hpp"

namespace scarp::check {
namespace {

constexpr double wanted_seconds = 3.0, most_seconds = 6.0;

/// Steps and wall time of a part of a run.
struct Part {
  double simulated = 0.0, steps = 0.0, wall_s = 0.0;
};

struct Rehearsal {
  Part start, whole;
  double spacing = 0.0;
  bool finished = false;
  int restless = 0;  ///< stages that waited for rest in vain
};

Rehearsal rehearse(const Scene& scene, const RunOptions& options, double start_time,
                   double patience) {
  using Clock = std::chrono::steady_clock;
  constexpr double fewest_steps = 50;  // fewer tell little about the cost of one
  Simulation simulation(scene, options);
  Rehearsal rehearsal;
  rehearsal.spacing = scene.spacing;
  const auto began = Clock::now();
  while (!simulation.finished() && rehearsal.whole.wall_s < patience * most_seconds) {
    simulation.step();
    rehearsal.whole = {simulation.last_step().time, rehearsal.whole.steps + 1,
                       std::chrono::duration<double>(Clock::now() - began).count()};
    const bool at_start =
        rehearsal.whole.steps <= fewest_steps || rehearsal.whole.simulated <= start_time;
    if (at_start) rehearsal.start = rehearsal.whole;
    const bool waits = scene.stages[simulation.stage_index()].until == StageEnd::rest;
    if (waits && simulation.stage_ended() && !simulation.stage_reached_rest()) ++rehearsal.restless;
  }
  rehearsal.finished = simulation.finished();
  return rehearsal;
}

/// The scene with the cost of a rehearsal; itself if that is no more. `wall_s` is NaN if a stage
/// has no limit: then with few particles.
Scene coarser(Scene scene, double wall_s, double particles, double wanted) {
  constexpr double few = 2000.0;
  // Particles go with spacing^-d, steps with 1/spacing.
  scene.spacing *= std::isnan(wall_s)
                       ? std::pow(std::max(1.0, particles / few), 1.0 / scene.dimension)
                       : std::pow(std::max(1.0, wall_s / wanted), 1.0 / (scene.dimension + 1.0));
  return scene;
}

/// On a lattice that does not fit its walls soil may never come to rest, on a slightly coarser one
/// again, which then takes its place.
Rehearsal rehearse_until_rest(const Scene& scene, const RunOptions& options, double start_time,
                              double patience) {
  const Rehearsal first = rehearse(scene, options, start_time, patience);
  if (!first.finished || first.restless == 0) return first;
  Scene coarser_still = scene;
  coarser_still.spacing *= 1.1;
  try {
    const Rehearsal second = rehearse(coarser_still, options, start_time, patience);
    return second.finished && second.restless < first.restless ? second : first;
  } catch (const Error&) {  // too coarse
    return first;
  }
}

}  // namespace

double longest_duration(const Scene& scene) {
  const bool limited = std::all_of(scene.stages.begin(), scene.stages.end(),
                                   [](const Stage& stage) { return stage.duration.has_value(); });
  return limited ? total_duration(scene) : std::numeric_limits<double>::quiet_NaN();
}

Forecast forecast(const Scene& scene, const RunOptions& options, const Trial& trial,
                  double patience) {
  Forecast plain;
  plain.simulated = longest_duration(scene);
  plain.steps = std::ceil(plain.simulated / trial.time_step);
  plain.wall_s = plain.steps * trial.seconds_per_step;
  if (std::isnan(trial.seconds_per_step) || !trial.failure.empty()) return plain;
  try {
    const Scene coarse = coarser(scene, plain.wall_s, trial.particles, patience * wanted_seconds);
    const bool is_the_run = coarse.spacing == scene.spacing;
    const Rehearsal rehearsal =
        (is_the_run ? rehearse : rehearse_until_rest)(coarse, options, trial.simulated, patience);
    const Part &start = rehearsal.start, &whole = rehearsal.whole;
    if (start.steps == 0.0) return plain;
    const double shorter_steps = whole.steps / whole.simulated * start.simulated / start.steps;
    const double dearer_steps = whole.wall_s / whole.steps * start.steps / start.wall_s;
    Forecast better;
    better.simulated = rehearsal.finished ? whole.simulated : plain.simulated;
    better.steps = std::ceil(better.simulated / trial.time_step * shorter_steps);
    better.wall_s = better.steps * trial.seconds_per_step * dearer_steps;
    if (rehearsal.finished && is_the_run) {
      better.steps = whole.steps;
      better.wall_s = whole.wall_s;
    }
    better.rehearsal_spacing = rehearsal.spacing;
    better.rehearsal_complete = rehearsal.finished ? 1.0 : whole.simulated / plain.simulated;
    return better;
  } catch (const Error&) {  // too coarse for its walls, or it came apart
    return plain;
  }
}

}  // namespace scarp::check
