// SPDX-License-Identifier: BSD-3-Clause
/// Trials with longer and shorter steps.
#include "engine/check/stability_margin.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/errors.hpp"

namespace scarp {
namespace {

constexpr double shake = 1e-6;     ///< over the sound speed
constexpr double restless = 10.0;  ///< times as fast as with a short step

/// Speed of the fastest particle at the end [m/s]; empty if the watch stopped it.
std::optional<double> attempt(const Simulation& start, double factor, double speed, int steps) {
  Simulation trial = start.clone();
  trial.perturb(speed);
  trial.set_step_factor(factor * start.step_factor());
  try {
    for (int k = 0; k < steps && !trial.finished(); ++k) trial.step();
    trial.require_sound();
  } catch (const SimulationInstability&) {
    return {};
  }
  return trial.last_step().max_velocity;
}

}  // namespace

double sound_speed(const Scene& scene) {
  double fastest = 0.0;
  for (const Material& material : scene.materials) {
    fastest = std::max(fastest, material.sound_speed());
  }
  return fastest;
}

StabilityMargin stability_margin(const Simulation& start, const MarginOptions& options) {
  const double speed = shake * sound_speed(start.scene());
  // Twice the steps: the same time as with the scene's own.
  const double calm = attempt(start, 0.5, speed, 2 * options.steps).value_or(0.0);
  const auto stays = [&](double factor) {
    const std::optional<double> end = attempt(start, factor, speed, options.steps);
    return end && *end <= restless * std::max(calm, speed);
  };
  StabilityMargin margin;
  double factor = 1.0;
  // Outward by halves of an octave until one holds and one does not.
  if (stays(factor)) {
    margin.stable = factor;
    while (margin.unstable == 0.0 && margin.stable < options.most) {
      factor = std::min(factor * std::sqrt(2.0), options.most);
      (stays(factor) ? margin.stable : margin.unstable) = factor;
    }
  } else {
    margin.unstable = factor;
    while (margin.stable == 0.0 && margin.unstable > options.least) {
      factor = std::max(factor / std::sqrt(2.0), options.least);
      (stays(factor) ? margin.stable : margin.unstable) = factor;
    }
  }
  while (margin.stable > 0.0 && margin.unstable > (1.0 + options.tolerance) * margin.stable) {
    factor = std::sqrt(margin.stable * margin.unstable);
    (stays(factor) ? margin.stable : margin.unstable) = factor;
  }
  return margin;
}

}  // namespace scarp
