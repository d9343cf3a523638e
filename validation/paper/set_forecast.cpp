// SPDX-License-Identifier: BSD-3-Clause
/// Forecast by trial steps, corrected by what has been.

#include "validation/paper/set_forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/check/trial.hpp"
#include "engine/plain_text.hpp"

namespace scarp::validation {

void SetForecast::plan(const std::string& case_name, const PlannedRun& run,
                       const RunOptions& options) {
  Simulation simulation(run.scene, options);
  const check::Trial trial = check::try_steps(simulation, 0.3);
  const double seconds = run.simulated_s / trial.time_step * trial.seconds_per_step;
  entries_.push_back({case_name, run.name, static_cast<double>(simulation.soil_count()),
                      std::isfinite(seconds) ? seconds : 0.0, false});
}

void SetForecast::print() const {
  if (quiet_ || entries_.empty()) return;
  fmt::print(stderr, "{:<18} {:<58} {:>10} {:>14}\n", "case", "run", "particles", "at most");
  for (const Entry& entry : entries_) {
    fmt::print(stderr, "{:<18} {:<58} {:>10.0f} {:>14}\n", entry.case_name, entry.run,
               entry.particles, readable_duration(entry.seconds));
  }
  fmt::print(stderr, "{} runs, together at most about {}; those that come to rest end before.\n",
             entries_.size(), readable_duration(total_s()));
}

double SetForecast::total_s() const {
  double sum = 0.0;
  for (const Entry& entry : entries_) sum += entry.seconds;
  return sum;
}

double SetForecast::done_s() const {
  double sum = 0.0;
  for (const Entry& entry : entries_) sum += entry.done ? entry.seconds : 0.0;
  return sum;
}

cli::WholeWork SetForecast::begin(const std::string& case_name, const std::string& run) {
  if (start_ == Clock::time_point{}) start_ = Clock::now();
  if (quiet_ || entries_.empty()) return {};
  const auto done = std::count_if(entries_.begin(), entries_.end(),
                                  [](const Entry& entry) { return entry.done; });
  const double total = total_s(), behind = done_s();
  // Runs that were shorter than their most, and a machine that others use, show in what has been.
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  const double scale = behind > 0.0 ? elapsed / behind : 1.0;
  double own = 0.0;
  for (const Entry& entry : entries_) {
    if (entry.case_name == case_name && entry.run == run) own = entry.seconds;
  }
  fmt::print(stderr, "set: run {} of {}, {:.0f} % behind, about {} left; {}: {}\n", done + 1,
             entries_.size(), total > 0.0 ? 100.0 * behind / total : 0.0,
             readable_duration((total - behind) * scale), case_name, run);
  return {fmt::format("run {} of {}", done + 1, entries_.size()),
          [after = (total - behind - own) * scale](double) { return after; }};
}

void SetForecast::end(const std::string& case_name, const std::string& run) {
  for (Entry& entry : entries_) {
    if (entry.case_name == case_name && entry.run == run) entry.done = true;
  }
}

void SetForecast::end(const std::string& case_name) {
  for (Entry& entry : entries_) {
    if (entry.case_name == case_name) entry.done = true;
  }
}

}  // namespace scarp::validation
