// SPDX-License-Identifier: BSD-3-Clause
/// Judges how an error falls with the spacing.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/case_run.hpp"

namespace scarp::validation {

/// What is asked of a series of errors, and why.
struct ConvergenceBand {
  double largest_at_finest = 0.0;     ///< of |error| at the finest spacing of the form
  std::optional<double> least_order;  ///< judged from three spacings on
  std::string source;
};

/// Adds the error at each spacing, judged at the finest one, and the observed order; keeps the
/// series for the report. `errors` coarse to fine.
void judge_convergence(CaseRun& run, const std::string& quantity,
                       const std::vector<ErrorAtSpacing>& errors, const ConvergenceBand& band);

}  // namespace scarp::validation
