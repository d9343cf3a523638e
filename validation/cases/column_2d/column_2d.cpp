// SPDX-License-Identifier: BSD-3-Clause
/// Granular columns in plane strain: run-out and height over aspect ratio against experiments.

#include "validation/case_list.hpp"
#include "validation/column_collapse.hpp"

namespace scarp::validation {
namespace {

constexpr RunOutLaw lube{2.3, 1.2, 1.9, 2.0 / 3.0}, lajeunesse{3.0, 1.8, 2.3, 2.0 / 3.0};

}  // namespace

void column_2d(CaseRun& run) {
  const LawBand laws{lube, lajeunesse, "Lube et al. 2005 and Lajeunesse et al. 2005", 2.0,
                     "ideal Drucker-Prager soil: 0.30 to 0.45 from a = 1 on"};
  ColumnPlan plan{{0.005, 0.0025, 0.1 / 60}, {0.5, 1.0, 2.0, 4.0}, 0.65, 2.0};
  if (run.short_form()) plan.aspect_ratios = {0.5, 1.0};
  judge_columns(run, plan, laws);
}

}  // namespace scarp::validation
