// SPDX-License-Identifier: BSD-3-Clause
/// Where a run stands, and the work that it is a part of.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "engine/cli/progress_line.hpp"
#include "engine/simulation.hpp"

namespace scarp::cli {

/// What a run is a part of; left out: it is all there is.
struct WholeWork {
  std::string part;  ///< "trial 3 of about 9"
  /// Time of what comes after the run [s], from what the run takes in all, as far as that is known
  /// by now [s]; empty: it cannot be said.
  std::function<double(double)> ahead = {};
};

/// The lines of one run.
class Progress {
 public:
  /// `total_time`: simulated time of all stages, at most [s]. What a simulation had behind it at
  /// the first `update` counts for nothing.
  Progress(double total_time, bool quiet, WholeWork whole = {});
  void update(const Simulation& simulation);
  /// Ends the bar's line.
  void end() { line_.finish(); }

 private:
  std::vector<std::string> words(const Simulation& simulation, double fraction) const;

  using Clock = std::chrono::steady_clock;
  ProgressLine line_;
  WholeWork whole_;
  Clock::time_point start_ = Clock::now();
  double total_time_, time_before_ = -1.0;  ///< [s]; negative: not known yet
  std::uint64_t steps_before_ = 0;
};

}  // namespace scarp::cli
