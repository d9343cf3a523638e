// SPDX-License-Identifier: BSD-3-Clause
/// Runs a problem under all settings of a plan and says what error costs.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/case_list.hpp"
#include "validation/error_time/plan.hpp"
#include "validation/error_time/run_log.hpp"

namespace scarp::validation {

struct StudyOptions {
  std::vector<std::string> axes;
  bool short_form = false;
  int repeats = 3;                 ///< see `repeats_for`
  std::optional<double> budget_s;  ///< no run begins that is not expected to end within it
  std::filesystem::path out = "out/error_time";
  RunOptions run;
  bool quiet = false;
};

/// What values are held against that have no error of their own.
struct Reference {
  double value = 0.0;
  /// Observed order of the three finest spacings by which the value is extrapolated to spacing 0;
  /// empty: the finest run's own value.
  std::optional<double> order;
};

/// A setting at a spacing, all its runs together.
struct Point {
  Trial trial;
  std::string setting;   ///< in words
  double spacing = 0.0;  ///< [m]
  Numerics numerics;
  RunStatus status = RunStatus::ok;
  std::string reason;
  bool reference = false;  ///< the finest run of those that the others are held against
  double error = 0.0;      ///< relative; NaN unless the run was ok
  double wall_s = 0.0;     ///< median over the repeats [s]
  double spread = 0.0;     ///< middle half of the run times over the median; NaN for a single run
  double cpu_s = 0.0;      ///< median [s]
  double particles = 0.0, steps = 0.0, particle_steps = 0.0, memory_bytes = 0.0;
  int repeats = 0;
  bool on_front = false;
};

struct ErrorStudy {
  std::string case_name, title, error;
  std::vector<double> spacings;  ///< of the problem, coarse to fine [m]
  std::vector<std::string> axes;
  bool short_form = false;
  Bench bench;
  std::vector<Point> points;
  std::vector<std::size_t> front;  ///< indices into `points`, by rising run time
  /// Presets that keep the moment of the lattice, and that moment.
  std::map<std::string, double> lattice_moments;
  std::optional<Reference> reference;  ///< if the problem has no error of its own
  std::size_t left_out = 0;            ///< runs that the budget left no time for
};

/// Median of wall and CPU time, error and status from the runs of each trial; then the front.
/// An outcome is the
/// error itself, or a value if one of the points is the reference.
void sum_up(ErrorStudy& study, const std::vector<std::pair<Point, std::vector<RunRecord>>>& runs);

/// Errors: Error, naming the cases that have one, if the case has no scalar error.
void require_problem(const CaseRow& row);

/// Runs what the log does not hold yet, round robin over the settings. Errors: those of
/// `require_problem`; FileError, SceneError.
ErrorStudy run_study(const CaseRow& row, const StudyOptions& options);

/// How often a setting is run whose first run took `wall_s`, if `usual` is the number for most:
/// once from 60 s, twice from 20 s, three times the usual number below 0.2 s, where runs scatter
/// most.
int repeats_for(double wall_s, int usual);

}  // namespace scarp::validation
