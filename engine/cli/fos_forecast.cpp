// SPDX-License-Identifier: BSD-3-Clause
/// What searches take as a rule, and at most.
#include "engine/cli/fos_forecast.hpp"

#include <fmt/format.h>

#include "engine/check/forecast.hpp"
#include "engine/check/trial.hpp"
#include "engine/cli/search_progress.hpp"
#include "engine/plain_text.hpp"

namespace scarp::cli {

std::string search_forecast(const Simulation& start, const Criterion& criterion,
                            const SearchOptions& search) {
  constexpr double timed = 0.5;     // [s]
  constexpr double patience = 0.3;  // of a rehearsal: a second
  Simulation copy = start.clone();
  const check::Trial steps = check::try_steps(copy, timed);
  Scene settling = start.scene();
  settling.stages.pop_back();
  const check::Forecast settles = check::forecast(settling, start.options(), steps, patience);
  const double seconds = steps.seconds_per_step / steps.time_step;  // a simulated second
  const double trials = trials_together(criterion) * seconds;
  const double most = check::longest_duration(settling) * seconds +
                      (1 + trials_left(search, {})) * (criterion.ramp + criterion.window) * seconds;
  return fmt::format("expected: {} to settle and {} for all trials; at most {}",
                     readable_duration(settles.wall_s), readable_duration(trials),
                     readable_duration(most));
}

std::string time_left(const SearchOptions& search, const FactorOfSafety& found) {
  const int left = trials_left(search, found.bracket);
  if (left == 0) return {};
  const std::string count = fmt::format("at most {} more {}", left, left == 1 ? "trial" : "trials");
  const std::optional<double> mean = seconds_per_trial(found);
  return mean ? fmt::format("{}, {}", count, readable_duration(left * *mean)) : count;
}

}  // namespace scarp::cli
