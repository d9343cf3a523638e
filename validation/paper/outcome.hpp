// SPDX-License-Identifier: BSD-3-Clause
/// The numbers that one run leaves for the judgement of its case, kept in a file beside its frames.
#pragma once

#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/acceptance.hpp"

namespace scarp::validation {

struct Outcome {
  std::string name;                      ///< of the run, in words
  std::string folder;                    ///< below the case's
  std::string key;                       ///< of everything that decides it; see `outcome_key`
  bool complete = false;                 ///< the run has reached its end
  std::map<std::string, double> values;  ///< by name with unit, SI
  std::vector<RunCost> costs;  ///< of its stages, and of their parts before an interruption

  /// NaN if it was not measured.
  double at(const std::string& value) const {
    const auto found = values.find(value);
    return found == values.end() ? std::nan("") : found->second;
  }
};

/// Reads outcome.json of a run's folder; empty if there is none that can be read.
std::optional<Outcome> read_outcome(const std::filesystem::path& folder);

/// Errors: FileError.
void write_outcome(const std::filesystem::path& folder, const Outcome& outcome);

}  // namespace scarp::validation
