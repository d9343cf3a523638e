// SPDX-License-Identifier: BSD-3-Clause
/// Measures of a validation case, their verdict, and the two forms they are published in.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "engine/output/results.hpp"
#include "validation/paper/claims.hpp"

namespace scarp::validation {

/// A number without a verdict; `remark` says what it depends on or compares with.
Measure reported(std::string name, double value, std::string unit, std::string remark = {});

/// A number that must lie in `lowest`..`highest`; NaN fails.
Measure within(std::string name, double value, std::string unit, std::optional<double> reference,
               double lowest, double highest, std::string source);

/// A yes/no statement, written as 1 or 0, that must be 1.
Measure holds(std::string name, bool truth, std::string source);

/// One simulated run of a case.
struct RunCost {
  std::string name;
  std::uint64_t steps = 0;
  double particle_steps = 0.0;
  double simulated_s = 0.0;
  double wall_s = 0.0;
  double cpu_s = 0.0;         ///< of all threads
  double memory_bytes = 0.0;  ///< of the simulation at the end
};

/// As it stands in results.json and outcome.json.
void to_json(nlohmann::ordered_json& json, const RunCost& run);
void from_json(const nlohmann::ordered_json& json, RunCost& run);

struct ErrorAtSpacing {
  double spacing = 0.0;  ///< [m]
  double error = 0.0;
};

/// How an error falls with the spacing.
struct ConvergenceSeries {
  std::string quantity;
  std::vector<ErrorAtSpacing> errors;  ///< coarse to fine
  double order = 0.0;                  ///< observed, see `observed_order`; NaN for one spacing
};

/// Slope of log |error| over log spacing by least squares; NaN if fewer than two errors are above
/// 0.
double observed_order(const std::vector<ErrorAtSpacing>& errors);

struct CaseResult {
  std::string case_name;
  std::string title;    ///< of the case's own scene; empty: that of the last one run
  std::string form;     ///< "short", "main" or "full"
  std::string options;  ///< see `options_key`
  std::vector<Measure> measures;
  std::vector<ClaimLine> claims;  ///< of the paper; never judged as pass or fail
  std::vector<StageResult> stages;
  std::vector<RunCost> runs;
  std::vector<ConvergenceSeries> convergence;
  double wall_s = 0.0;  ///< of the whole case [s]
  std::string failure;  ///< why the case did not reach its end; empty if it did
};

/// True if the case reached its end, judged something and nothing it judged failed.
bool passed(const CaseResult& result);

/// results.json as `engine/output/FORMATS.md` has it, with "form", "runs" and the cost of all runs.
/// `simulation` gives the facts of the run; null if the case failed before there was one. Errors:
/// FileError.
void write_case_results(const std::filesystem::path& path, const Simulation* simulation,
                        const CaseResult& result);

/// The measures as a table for people, verdict first, ending with a line for the case.
std::string console_table(const CaseResult& result);

}  // namespace scarp::validation
