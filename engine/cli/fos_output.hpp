// SPDX-License-Identifier: BSD-3-Clause
/// What `scarp fos` prints and writes.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/fos/strength_reduction.hpp"

namespace scarp::cli {

/// A search and what it was done with.
struct FosReport {
  FactorOfSafety found;
  Criterion criterion;
  double settle_wall_s = 0.0, settle_time = 0.0;  ///< [s]
  bool settled_at_rest = false;
  double strengthening = 1.0;  ///< of the stages it settled in, over what the scene gives them
  std::string failure;         ///< why the search did not reach its end; empty if it did
};

/// "SRF 1.375: fails, 0.1 m after 2.1 s ..." and what is known by then.
std::string trial_sentence(const Trial& trial, const Bracket& bracket);

/// The factor, its bracket, the criterion, the dependence on the spacing, and what limits them.
std::string fos_text(const FosReport& report, const Simulation& settled);

/// fos.json, version 1 (`engine/output/FORMATS.md`).
std::string fos_json(const FosReport& report, const Simulation& settled);

/// A trial as fos.json and search.json have it.
nlohmann::ordered_json json_of(const Trial& trial);

/// Titles and cells of fos.csv: one row for each trial.
std::vector<std::string> trial_titles();
std::vector<double> trial_cells(const Trial& trial);

/// What ended a trial: "limit crossed", "came to rest", "window over".
const char* word(TrialEnd end);

}  // namespace scarp::cli
