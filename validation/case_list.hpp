// SPDX-License-Identifier: BSD-3-Clause
/// The registry: one row per case.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "validation/case_run.hpp"

namespace scarp::validation {

/// A case adds its measures and ends with `CaseRun::finish`. Errors: those of the library.
using CaseFunction = void (*)(CaseRun&);

void slope_2d(CaseRun& run);
void cuboid_3d(CaseRun& run);

struct CaseRow {
  std::string_view name;
  std::string_view set;  ///< "paper" or "verification"
  std::string_view sentence;
  CaseFunction function;
};

inline constexpr std::array<CaseRow, 2> case_list{{
    {"slope_2d", "paper", "Cohesive slope in plane strain, strength cut by 1.4 (sample 1).",
     slope_2d},
    {"cuboid_3d", "paper", "Collapse of a granular cuboid behind a gate (sample 2).", cuboid_3d},
}};

/// Cases and sets by name ("paper", "verification", "all"), each case once, in the order asked for.
/// Errors: Error naming what exists.
std::vector<const CaseRow*> select_cases(const std::vector<std::string>& names);

}  // namespace scarp::validation
