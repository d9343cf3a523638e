// SPDX-License-Identifier: BSD-3-Clause
/// Which run of the search a step belongs to, and what comes after it.
#include "engine/cli/search_progress.hpp"

#include <fmt/format.h>

#include "engine/run/run.hpp"

namespace scarp::cli {

double trials_together(const Criterion& criterion) {
  const double to_the_end = criterion.ramp + criterion.window;
  return criterion.early_stop ? to_the_end : 2.0 * to_the_end;
}

SearchProgress::SearchProgress(const Scene* to_settle, const Criterion& criterion,
                               const SearchOptions& search, bool quiet)
    : criterion_(criterion), search_(search), quiet_(quiet) {
  if (to_settle == nullptr) return;
  trial_stage_ = to_settle->stages.size() - 1;
  settling_time_ = total_duration(*to_settle) - to_settle->stages.back().duration.value_or(0.0);
}

bool SearchProgress::operator()(const Simulation& now) {
  const bool settling = now.stage_index() < trial_stage_;
  if (settling != settling_) end();  // the elastic response follows without a word
  settling_ = settling;
  if (!line_)
    line_.emplace(settling ? settling_time_ : total_duration(now.scene()), quiet_, whole(settling));
  line_->update(now);
  return true;
}

void SearchProgress::end() {
  if (line_) line_->end();
  line_.reset();
}

void SearchProgress::learn(const FactorOfSafety& found) { found_ = found; }

WholeWork SearchProgress::whole(bool settling) const {
  if (showing_failure_) return {"the failure, for its figures"};
  const double together = trials_together(criterion_);
  if (settling) {
    return {"settling", [together, settling_time = settling_time_](double run) {
              return settling_time > 0.0 ? together * run / settling_time : 0.0;
            }};
  }
  const int left = trials_left(search_, found_.bracket);
  const std::size_t done = found_.trials.size();
  if (const std::optional<double> mean = seconds_per_trial(found_); mean && done > 0) {
    return {fmt::format("trial {} of about {}", done + 1, done + left),
            [after = (left - 1) * *mean](double) { return after; }};
  }
  // What the first runs take is not known before they end.
  const double one = criterion_.ramp + criterion_.window;
  const bool elastic = !(found_.elastic.wall_s > 0.0);
  return {elastic ? "elastic response" : fmt::format("trial 1 of about {}", left),
          [share = together / one](double run) { return share * run; }};
}

std::optional<double> seconds_per_trial(const FactorOfSafety& found) {
  double sum = found.elastic.wall_s;
  int run = found.elastic.wall_s > 0.0 ? 1 : 0;
  for (const Trial& trial : found.trials) {
    sum += trial.wall_s;
    run += trial.wall_s > 0.0 ? 1 : 0;
  }
  return run > 0 ? std::optional(sum / run) : std::nullopt;
}

}  // namespace scarp::cli
