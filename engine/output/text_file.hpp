// SPDX-License-Identifier: BSD-3-Clause
/// Small text files of a run: whole files replaced at once, and tables that grow row by row.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace scarp {

/// Writes "PATH.part", then renames it, so that a reader never sees half a file. Errors: FileError.
void replace_file(const std::filesystem::path& path, std::string_view text);

/// A CSV file (RFC 4180) with one header line; each row is flushed, so a killed run keeps its rows.
/// Errors: FileError.
class CsvFile {
 public:
  CsvFile(std::filesystem::path path, const std::vector<std::string>& header);
  CsvFile& operator<<(double value);
  CsvFile& operator<<(std::string_view text);
  void end_row();

 private:
  void check() const;

  std::filesystem::path path_;
  std::ofstream stream_;
  std::string row_;
};

}  // namespace scarp
