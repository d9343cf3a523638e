// SPDX-License-Identifier: BSD-3-Clause
/// `scarp-validate stability`.
#pragma once

#include <string>

#include "engine/simulation.hpp"

namespace scarp::validation {

struct StabilityArguments {
  std::string out = "out";
  std::string json;  ///< file for the map as JSON, - for standard output
  std::string axis;  ///< only axes and groups whose name holds this; empty: all
  bool short_form = false, quiet = false;
  RunOptions run;
};

/// Runs the cells that the log does not hold yet and leaves table, map and page in OUT/stability.
/// Returns the exit code: 1 if a cell failed. Errors: FileError.
int stability_command(const StabilityArguments& arguments);

}  // namespace scarp::validation
