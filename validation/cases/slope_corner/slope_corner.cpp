// SPDX-License-Identifier: BSD-3-Clause
/// Case 2: slopes that turn a concave and a convex corner, and the plane counterparts of their
/// sections.

#include "validation/case_list.hpp"
#include "validation/cases/slope_corner/corner_claims.hpp"
#include "validation/paper/slope_judgement.hpp"

namespace scarp::validation {
namespace {

/// The second spacing is the coarser one, and all but the first readings are run at it: corners
/// hold two to four times the soil of case 1.
const ReadingPlan plan{{SlopeShape::concave_corner, SlopeShape::convex_corner, SlopeShape::plane_35,
                        SlopeShape::plane_45},
                       2.0};

}  // namespace

std::vector<PlannedRun> slope_corner_runs(const CaseRun& run) { return planned_runs(run, plan); }

void slope_corner(CaseRun& run) {
  std::vector<ReadingOutcomes> readings = run_readings(run, plan);
  judge_slopes(run, readings);
  add_outcomes_of(
      "slope_curvature", run,
      {{SlopeShape::concave, SlopeShape::straight, SlopeShape::convex}, plan.other_spacing},
      readings);
  judge_corner_claims(run, readings);
  run.finish(nullptr);
}

}  // namespace scarp::validation
