// SPDX-License-Identifier: BSD-3-Clause
/// Trials to come times the steps or the time of one.
#include "engine/cli/fos_forecast.hpp"

#include <fmt/format.h>

#include "engine/check/trial.hpp"
#include "engine/cli/search_progress.hpp"
#include "engine/plain_text.hpp"

namespace scarp::cli {

std::string search_forecast(const Simulation& start, const Criterion& criterion,
                            const SearchOptions& search) {
  Simulation copy = start.clone();
  const check::Trial steps = check::try_steps(copy, 0.5);
  const Scene& scene = start.scene();
  double settling = 0.0;
  for (std::size_t s = 0; s + 1 < scene.stages.size(); ++s)
    settling += scene.stages[s].duration.value_or(0.0);
  const double seconds = steps.seconds_per_step / steps.time_step;  // a simulated second
  const double one = (criterion.ramp + criterion.window) * seconds;
  const int trials = 1 + trials_left(search, {});  // the elastic response first
  return fmt::format(
      "expected at most: {} to settle ({:.3g} s), {} trials of {} ({:.3g} s each), {} in all; "
      "slopes "
      "that rest or fail early take less",
      readable_duration(settling * seconds), settling, trials, readable_duration(one),
      criterion.ramp + criterion.window, readable_duration(settling * seconds + trials * one));
}

std::string time_left(const SearchOptions& search, const FactorOfSafety& found) {
  const int left = trials_left(search, found.bracket);
  if (left == 0) return {};
  const std::string count = fmt::format("at most {} more {}", left, left == 1 ? "trial" : "trials");
  const std::optional<double> mean = seconds_per_trial(found);
  return mean ? fmt::format("{}, {}", count, readable_duration(left * *mean)) : count;
}

}  // namespace scarp::cli
