// SPDX-License-Identifier: BSD-3-Clause
/// Measures of a convergence series.

#include "validation/convergence.hpp"

#include <fmt/format.h>

#include <limits>

namespace scarp::validation {

void judge_convergence(CaseRun& run, const std::string& quantity,
                       const std::vector<ErrorAtSpacing>& errors, const ConvergenceBand& band) {
  const double order = observed_order(errors);
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const std::string name = fmt::format("{}, dx = {:.4g} m", quantity, errors[k].spacing);
    if (k + 1 < errors.size()) {
      run.add(reported(name, errors[k].error, ""));
    } else {
      run.add(within(name, errors[k].error, "", 0.0, -band.largest_at_finest,
                     band.largest_at_finest, band.source));
    }
  }
  const std::string name = fmt::format("{}, observed order", quantity);
  if (band.least_order && errors.size() >= 3) {
    run.add(within(name, order, "", {}, *band.least_order, std::numeric_limits<double>::infinity(),
                   "slope of log error over log spacing"));
  } else if (errors.size() >= 2) {
    run.add(reported(name, order, "", "slope of log error over log spacing"));
  }
  run.add({quantity, errors, order});
}

}  // namespace scarp::validation
