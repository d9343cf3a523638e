// SPDX-License-Identifier: BSD-3-Clause
/// What `scarp converge` prints and writes.
#pragma once

#include <string>
#include <vector>

#include "engine/converge/study.hpp"

namespace scarp::cli {

/// The table of the sizes and the advice, for people.
std::string study_text(const Study& study);

/// One sentence for each target: which spacing, at what cost, or why none.
std::vector<std::string> advice_sentences(const Study& study);

/// converge.json, version 1 (`engine/output/FORMATS.md`).
std::string study_json(const Study& study, const Scene& scene, const std::string& isa, int threads);

/// Writes converge.csv: one row for each quantity. Errors: FileError.
void write_study_csv(const std::string& path, const Study& study);

}  // namespace scarp::cli
