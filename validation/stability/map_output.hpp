// SPDX-License-Identifier: BSD-3-Clause
/// Log, JSON, CSV and sentences of the stability map; formats in `engine/output/FORMATS.md`.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/error_time/run_log.hpp"
#include "validation/stability/cell_run.hpp"

namespace scarp::validation {

/// What decides a cell's record, hashed: the program, its instruction set, threads, scene, lengths.
std::string cell_key(const Bench& bench, const Cell& cell);

/// One line for each cell that has run; lines that cannot be read count as not there.
class CellLog {
 public:
  /// Errors: FileError if it cannot be appended to.
  explicit CellLog(std::filesystem::path path);
  const CellRecord* find(const std::string& key) const;
  /// Errors: FileError.
  void append(const CellRecord& record);

 private:
  std::filesystem::path path_;
  std::map<std::string, CellRecord> records_;
};

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
