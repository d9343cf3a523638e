// SPDX-License-Identifier: BSD-3-Clause
/// Granular cylinders in 3D: run-out over aspect ratio against experiments.

#include <fmt/format.h>

#include "validation/case_list.hpp"
#include "validation/column_collapse.hpp"

namespace scarp::validation {
namespace {

constexpr double radius = 0.1;  // [m]
constexpr RunOutLaw lube{1.7, 1.24, 1.6, 0.5}, lajeunesse{0.74, 1.0, 2.0, 0.5};

}  // namespace

void column_axisymmetric(CaseRun& run) {
  const LawBand laws{lube, lajeunesse, "Lube et al. 2004 and Lajeunesse et al. 2004", 2.0, ""};
  ColumnPlan plan{{radius / 15}, {0.5, 1.0, 2.0}, 0.0, 1.0};
  if (run.short_form()) {
    plan.spacings = {radius / 12};
    plan.aspect_ratios = {1.0};
  }
  if (run.options().form == Form::full) plan.spacings = {radius / 10, radius / 15, radius / 20};
  judge_columns(run, plan, laws);
}

}  // namespace scarp::validation
