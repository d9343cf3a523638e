// SPDX-License-Identifier: BSD-3-Clause
/// What the paper leaves open, and the runs that show which of its statements depend on it.
#pragma once

#include <map>
#include <span>
#include <string>
#include <vector>

#include "validation/paper/set_forecast.hpp"
#include "validation/paper/slope_measures.hpp"
#include "validation/paper/study_run.hpp"

namespace scarp::validation {

/// One choice of everything that is open.
struct Reading {
  std::string name;
  Cone cone = Cone::outer;        ///< of the 3D slopes
  Cone plane_cone = Cone::outer;  ///< of the plane counterparts
  std::string preset;             ///< empty: the scene's
  SlopeSize size;
  double spacing = 0.0;  ///< [m]
};

/// Outcomes of all shapes under one reading.
struct ReadingOutcomes {
  std::string reading;
  SlopeSize size;
  std::map<SlopeShape, Outcome> outcomes;
  const Outcome& of(SlopeShape shape) const { return outcomes.at(shape); }
  bool has(SlopeShape shape) const { return outcomes.count(shape) != 0; }
};

/// What a case runs of each reading.
struct ReadingPlan {
  std::vector<SlopeShape> shapes;
  double other_spacing = 1.0;  ///< of the full form's second spacing, over the first
};

/// The first is the one the others are held against. Short and main form: the paper's own pair of
/// cones besides; full: the plane strain cone throughout, the other preset and another height,
/// these at the coarser of the two spacings, and the plan's other spacing.
std::vector<Reading> readings(const CaseRun& run, const ReadingPlan& plan);

/// The runs still to come, each once however many readings need it.
std::vector<PlannedRun> planned_runs(const CaseRun& run, const ReadingPlan& plan);

/// Runs them all. Errors: SceneError, FileError.
std::vector<ReadingOutcomes> run_readings(CaseRun& run, const ReadingPlan& plan);

/// Adds what another case's runs of the same readings have left in the same output folder; nothing
/// where they have not been run.
void add_outcomes_of(const std::string& case_name, const CaseRun& run, const ReadingPlan& plan,
                     std::vector<ReadingOutcomes>& all);

/// When a probe failed, see `watch_probes` [s]: infinite if it never did, NaN if the run did not
/// reach its end.
double failed_after(const Outcome& outcome, const std::string& probe);

/// A statement of the paper and how a reading's outcomes answer it.
struct ReadingClaim {
  const char *section, *quote, *measure;
  Finding (*find)(const ReadingOutcomes&);
};

/// Adds one line for each statement, over all readings.
void judge_claims(CaseRun& run, std::span<const ReadingClaim> claims,
                  const std::vector<ReadingOutcomes>& readings);

}  // namespace scarp::validation
