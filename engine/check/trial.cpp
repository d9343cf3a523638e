// SPDX-License-Identifier: BSD-3-Clause
/// Timed steps.

#include "engine/check/trial.hpp"

#include <chrono>
#include <limits>

#include "engine/errors.hpp"

namespace scarp::check {

Trial try_steps(Simulation& simulation, double enough) {
  using Clock = std::chrono::steady_clock;
  constexpr int warm_up = 20, most = 5000;
  Trial trial;
  trial.seconds_per_step = std::numeric_limits<double>::quiet_NaN();
  try {
    const auto began = Clock::now();
    const auto since = [](Clock::time_point start) {
      return std::chrono::duration<double>(Clock::now() - start).count();
    };
    for (int n = 0; n < warm_up && !simulation.finished() && (n == 0 || since(began) < enough); ++n)
      trial.time_step = simulation.step().time_step;
    const auto start = Clock::now();
    double simulated = 0.0;
    for (int n = 1; n <= most && !simulation.finished(); ++n) {
      simulated += simulation.step().time_step;
      const double elapsed = since(start);
      trial.time_step = simulated / n;
      trial.seconds_per_step = elapsed / n;
      if (elapsed > enough) break;
    }
  } catch (const SimulationInstability& instability) {
    trial.failure = instability.what();
  }
  trial.simulated = simulation.last_step().time;
  trial.memory = simulation.memory_bytes();
  trial.particles = static_cast<double>(simulation.soil_count());
  return trial;
}

}  // namespace scarp::check
