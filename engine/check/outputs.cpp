// SPDX-License-Identifier: BSD-3-Clause
/// Outputs made once, to see what they cost.
#include "engine/check/outputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "engine/machine.hpp"
#include "engine/output/checkpoint_file.hpp"
#include "engine/output/frame_writer.hpp"
#include "engine/plain_text.hpp"

namespace scarp::check {

OutputTrial try_outputs(const Simulation& simulation) {
  OutputTrial trial;
  if (simulation.scene().output.frames) {
    const auto began = std::chrono::steady_clock::now();
    trial.frame_bytes = static_cast<double>(soil_frame_bytes(simulation));
    trial.frame_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }
  trial.checkpoint_bytes = static_cast<double>(checkpoint_bytes(simulation.snapshot()));
  trial.peak_bytes = resident_memory().peak;
  if (simulation.scene().retries > 0) trial.peak_bytes += 2.0 * trial.checkpoint_bytes;
  return trial;
}

OutputTrial scaled(OutputTrial trial, double share) {
  for (double* cost :
       {&trial.frame_bytes, &trial.frame_seconds, &trial.checkpoint_bytes, &trial.peak_bytes})
    *cost *= share;
  return trial;
}

double expected_frames(const Scene& scene, const Forecast& forecast) {
  if (!scene.output.frames) return 0.0;
  const double of_stages = 1.0 + static_cast<double>(scene.stages.size());
  if (!scene.output.frame_interval) return of_stages;
  return of_stages + std::min(forecast.simulated / *scene.output.frame_interval, forecast.steps);
}

std::string frames_warning(const Scene& scene, const Forecast& forecast, const OutputTrial& trial) {
  const double frames = expected_frames(scene, forecast);
  constexpr double often = 0.5;  // of the steps
  if (!scene.output.frame_interval || !(frames > often * forecast.steps)) return {};
  return fmt::format(
      "output.every = {:g} s: a frame follows almost every step, about {:.0f} in all, {} and {} of "
      "the run. Try a longer interval.",
      *scene.output.frame_interval, frames, readable_bytes(frames * trial.frame_bytes),
      readable_duration(frames * trial.frame_seconds));
}

}  // namespace scarp::check
