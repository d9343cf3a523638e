// SPDX-License-Identifier: BSD-3-Clause
/// `scarp-validate error-time`.
#pragma once

#include <string>
#include <vector>

#include "validation/error_time/study.hpp"

namespace scarp::validation {

struct ErrorTimeArguments {
  std::vector<std::string> cases;  ///< names, sets, or none: every case that has a scalar error
  std::vector<std::string> axes;
  std::string budget;  ///< "90 min"; empty: none
  std::string json;    ///< file for the overall JSON, - for standard output
  std::string out = "out";
  StudyOptions options;
};

/// Studies the cases one after the other and leaves tables, figures and a page in OUT/error_time.
/// Returns the exit code. Errors: those of the library, UnitError for the budget.
int error_time_command(const ErrorTimeArguments& arguments);

}  // namespace scarp::validation
