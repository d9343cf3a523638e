// SPDX-License-Identifier: BSD-3-Clause
/// Small text files of a run: whole files replaced at once, and tables that grow row by row.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scarp {

/// Writes "PATH.part", then renames it, so that a reader never sees half a file. Errors: FileError.
void replace_file(const std::filesystem::path& path, std::string_view text);

/// The same for data that must survive a power cut: the parts, one behind the other, are on the
/// disk before PATH names them. Errors: FileError; what was at PATH stays.
void replace_file_durably(const std::filesystem::path& path,
                          std::span<const std::string_view> parts);

/// Waits until a file or folder is on the disk. Errors: FileError.
void flush_to_disk(const std::filesystem::path& path);

/// A CSV file (RFC 4180) with one header line; each row is flushed, so a killed run keeps its rows.
/// Errors: FileError.
class CsvFile {
 public:
  CsvFile(std::filesystem::path path, const std::vector<std::string>& header);
  /// Goes on behind the first `bytes` of a file that is there; what follows them is cut off.
  /// Errors: CheckpointError if it is shorter.
  CsvFile(std::filesystem::path path, std::uintmax_t bytes);
  CsvFile& operator<<(double value);
  CsvFile& operator<<(std::string_view text);
  void end_row();
  /// On the disk, how much of it. Errors: FileError.
  std::uintmax_t flushed_bytes() const;

 private:
  void check() const;

  std::filesystem::path path_;
  std::ofstream stream_;
  std::string row_;
};

}  // namespace scarp
