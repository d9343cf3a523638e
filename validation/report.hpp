// SPDX-License-Identifier: BSD-3-Clause
/// Figures and page of a case, drawn by `validation/report.py`.
#pragma once

#include <filesystem>
#include <string>

namespace scarp::validation {

/// Draws the report of a case's folder; returns a line for people: where it is, or why there is
/// none: a machine without Python still has its verdict. `quiet`: no progress. Errors: Stopped.
std::string write_report(const std::filesystem::path& folder, bool quiet = false);

}  // namespace scarp::validation
