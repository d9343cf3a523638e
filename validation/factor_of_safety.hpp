// SPDX-License-Identifier: BSD-3-Clause
/// What the cases with a factor of safety share: slope from scene, search with its cost, tables.
#pragma once

#include <filesystem>
#include <string>

#include "engine/fos/strength_reduction.hpp"
#include "validation/bishop.hpp"
#include "validation/case_run.hpp"

namespace scarp::validation {

/// The slope of a scene for Bishop's method: its first body is a polygon that runs
/// counter-clockwise from the lower left corner along a level base; the ground is the rest. Dry,
/// first material.
Slope slope_of(const Scene& scene);

/// Factor, circle and ground line as JSON. Errors: FileError.
void write_bishop(const std::filesystem::path& path, const Slope& slope,
                  const BishopResult& bishop);

/// The search with progress and cost, each trial booked as `name` and its factor. Errors: those of
/// `find_factor`.
FactorOfSafety search_factor(CaseRun& run, const std::string& name, StrengthReduction& slope,
                             const SearchOptions& search);

/// Judges the middle of the bracket to lie within 4 % of `reference`; a search without end fails.
void judge_factor(CaseRun& run, const std::string& name, const Bracket& bracket, double reference,
                  const std::string& source);

/// One row for each trial, by rising factor. Errors: FileError.
void write_trials(const std::filesystem::path& path, const FactorOfSafety& found);

}  // namespace scarp::validation
