// SPDX-License-Identifier: BSD-3-Clause
/// A study as JSON, CSV and text; formats in `engine/output/FORMATS.md`.
#pragma once

#include <filesystem>
#include <string>

#include "validation/error_time/study.hpp"

namespace scarp::validation {

/// Writes <case>.json and <case>.csv into the folder. Errors: FileError.
void write_study(const std::filesystem::path& folder, const ErrorStudy& study);

/// Writes error_time.json: the sentences of every case whose <case>.json lies in the folder.
/// Returns its text. Errors: FileError.
std::string write_overall(const std::filesystem::path& folder);

/// The front as a table for people, then the sentences.
std::string study_text(const ErrorStudy& study);

}  // namespace scarp::validation
