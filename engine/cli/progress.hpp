// SPDX-License-Identifier: BSD-3-Clause
/// Where a run stands, on stderr: a bar on a terminal, a plain line every few seconds elsewhere.
#pragma once

#include <chrono>
#include <string>

#include "engine/simulation.hpp"

namespace scarp::cli {

class Progress {
 public:
  /// `total_time`: simulated time of all stages, at most [s]. What a simulation had behind it at
  /// the first `update` counts for nothing.
  Progress(double total_time, bool quiet);
  void update(const Simulation& simulation);
  /// Ends the bar's line.
  void end();

 private:
  std::string text(const Simulation& simulation, double elapsed, double fraction) const;

  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now(), last_ = start_;
  double total_time_, time_before_ = -1.0;  ///< [s]; negative: not known yet
  std::uint64_t steps_before_ = 0;
  bool quiet_, terminal_, drawn_ = false;
};

}  // namespace scarp::cli
