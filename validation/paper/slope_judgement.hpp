// SPDX-License-Identifier: BSD-3-Clause
/// What every run of a 3D slope is judged by, whatever the paper says of it.
#pragma once

#include "validation/paper/readings.hpp"

namespace scarp::validation {

/// Judged over all runs: their end, mass, rest before the cut, symmetry about a corner's diagonal.
/// Reported for each: displacements of the probes, slide body, end of the slide.
void judge_slopes(CaseRun& run, const std::vector<ReadingOutcomes>& readings);

}  // namespace scarp::validation
