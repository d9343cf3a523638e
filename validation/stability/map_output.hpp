// SPDX-License-Identifier: BSD-3-Clause
/// Log, JSON, CSV and sentences of the stability map; formats in `engine/output/FORMATS.md`.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/error_time/run_log.hpp"
#include "validation/record_log.hpp"
#include "validation/stability/cell_run.hpp"

namespace scarp::validation {

/// What decides a cell's record, hashed: the program, its instruction set, threads, scene, lengths.
std::string cell_key(const Bench& bench, const Cell& cell);

nlohmann::ordered_json json_of(const CellRecord& record);
/// False if the verdict is none; a JSON exception where a field is missing.
bool read(const nlohmann::ordered_json& json, CellRecord& record);

/// One line for each cell that has run.
using CellLog = RecordLog<CellRecord>;

struct CellOutcome {
  Cell cell;
  CellRecord record;
};

/// The map in words: how many cells hold, what does not and why, where paper fails and modern
/// holds, the narrowest margin of each preset.
std::vector<std::string> map_sentences(const std::vector<CellOutcome>& outcomes);

/// Writes stability.json and stability.csv; returns the text of the first. Errors: FileError.
std::string write_map(const std::filesystem::path& folder, const Bench& bench, bool short_form,
                      const std::vector<CellOutcome>& outcomes);

}  // namespace scarp::validation
