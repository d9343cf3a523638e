// SPDX-License-Identifier: BSD-3-Clause
/// What the paper says of its case 2.
#pragma once

#include <vector>

#include "validation/paper/readings.hpp"

namespace scarp::validation {

/// Adds one line for each statement, over all readings.
void judge_corner_claims(CaseRun& run, const std::vector<ReadingOutcomes>& readings);

}  // namespace scarp::validation
