// SPDX-License-Identifier: BSD-3-Clause
/// Where a search for a factor of safety stands: it settles, then it tries factor after factor.
#pragma once

#include <optional>

#include "engine/cli/progress.hpp"
#include "engine/fos/strength_reduction.hpp"

namespace scarp::cli {

/// Simulated time of the elastic response and all trials of a search together [s], as a rule: that
/// of one trial that runs to the end of its window (0.8 to 1.15 of it in searches of six slopes),
/// twice that where a soil softens (2.0 in one).
double trials_together(const Criterion& criterion);

/// Lines for each run of a search, begun at its first step, with what the trials to come may take:
/// as long as those that have been, and before there are any what all take together as a rule.
class SearchProgress {
 public:
  /// `to_settle`: the scene, if it is settled first.
  SearchProgress(const Scene* to_settle, const Criterion& criterion, const SearchOptions& search,
                 bool quiet);
  /// After each step of any of them; always true.
  bool operator()(const Simulation& now);
  /// Ends the lines of the run at hand.
  void end();
  /// What is known now, after a trial.
  void learn(const FactorOfSafety& found);
  /// The runs from here on show how the slope fails, and nothing comes after them.
  void show_failure() { showing_failure_ = true; }

 private:
  WholeWork whole(bool settling) const;

  Criterion criterion_;
  SearchOptions search_;
  bool quiet_, showing_failure_ = false;
  std::size_t trial_stage_ = 0;  ///< from this stage on it is a trial
  double settling_time_ = 0.0;   ///< at most [s]
  FactorOfSafety found_;
  std::optional<Progress> line_;
  bool settling_ = false;  ///< what `line_` is of
};

/// Mean of the trials that were run [s]; nothing before there are any.
std::optional<double> seconds_per_trial(const FactorOfSafety& found);

}  // namespace scarp::cli
