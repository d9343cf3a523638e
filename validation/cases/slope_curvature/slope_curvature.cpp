// SPDX-License-Identifier: BSD-3-Clause
/// Case 1: concave, straight and convex slopes and their plane counterpart.

#include "validation/case_list.hpp"
#include "validation/cases/slope_curvature/curvature_claims.hpp"
#include "validation/paper/slope_judgement.hpp"

namespace scarp::validation {
namespace {

const ReadingPlan plan{
    {SlopeShape::concave, SlopeShape::straight, SlopeShape::convex, SlopeShape::plane_45},
    1.0 / 1.5};

}  // namespace

std::vector<PlannedRun> slope_curvature_runs(const CaseRun& run) { return planned_runs(run, plan); }

void slope_curvature(CaseRun& run) {
  const std::vector<ReadingOutcomes> readings = run_readings(run, plan);
  judge_slopes(run, readings);
  judge_curvature_claims(run, readings);
  run.finish(nullptr);
}

}  // namespace scarp::validation
