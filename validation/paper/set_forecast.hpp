// SPDX-License-Identifier: BSD-3-Clause
/// What a set of cases will take, and where it stands.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "engine/cli/progress.hpp"
#include "engine/simulation.hpp"

namespace scarp::validation {

/// A run of a case that is still to come.
struct PlannedRun {
  std::string name;  ///< as the case books it; in words
  Scene scene;
  double simulated_s = 0.0;  ///< at most; a run that comes to rest before is shorter
};

/// Prints on stderr unless quiet.
class SetForecast {
 public:
  explicit SetForecast(bool quiet) : quiet_(quiet) {}

  /// Times a few steps of the run. Errors: those of Simulation's constructor.
  void plan(const std::string& case_name, const PlannedRun& run, const RunOptions& options);
  /// What has been planned, as a table.
  void print() const;

  /// Says which run begins; returns what it is a part of, nothing if nothing has been planned.
  cli::WholeWork begin(const std::string& case_name, const std::string& run);
  void end(const std::string& case_name, const std::string& run);
  /// The same for everything of the case.
  void end(const std::string& case_name);

  double total_s() const;  ///< of all runs, by the forecast [s]
  double done_s() const;   ///< of those that have ended, by the forecast [s]

 private:
  using Clock = std::chrono::steady_clock;
  struct Entry {
    std::string case_name, run;
    double particles = 0.0, seconds = 0.0;
    bool done = false;
  };

  bool quiet_;
  std::vector<Entry> entries_;
  Clock::time_point start_{};  ///< of the first run
};

}  // namespace scarp::validation
