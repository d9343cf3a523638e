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

#include "engine/output/file_mark.hpp"

namespace scarp {

/// Writes "PATH.part", then renames it, so that a reader never sees half a file. Errors: FileError.
void replace_file(const std::filesystem::path& path, std::string_view text);

/// Writes where a user points to: a file at the end of links is replaced, and the links stay; into
/// a device, a pipe or a socket the text is written as into any stream. Errors: FileError.
void write_to_target(const std::filesystem::path& target, std::string_view text);

/// As `replace_file`, for data that must survive a power cut: the parts, one behind the other, are
/// on the disk before PATH names them. Errors: FileError; what was at PATH stays.
void replace_file_durably(const std::filesystem::path& path,
                          std::span<const std::string_view> parts);

/// Makes the folder that results go to, if it is not there. Errors: FileError.
void make_output_folder(const std::filesystem::path& folder);

/// Waits until a file or folder is on the disk. Errors: FileError.
void flush_to_disk(const std::filesystem::path& path);

/// A CSV file (RFC 4180) with one header line; each row is flushed, so a killed run keeps its rows.
/// Errors: FileError.
class CsvFile {
 public:
  CsvFile(std::filesystem::path path, const std::vector<std::string>& header);
  /// Goes on behind the bytes that `mark` is of; what follows them is cut off. Errors:
  /// CheckpointError if they are not there or not the same.
  CsvFile(std::filesystem::path path, const FileMark& mark);
  /// Goes on behind whatever whole rows are within the first `most` bytes of a file.
  static CsvFile as_it_is(std::filesystem::path path, std::uintmax_t most,
                          const std::vector<std::string>& header);
  CsvFile& operator<<(double value);
  CsvFile& operator<<(std::string_view text);
  void end_row();
  /// On the disk, what it holds. Errors: FileError.
  FileMark flushed() const;

 private:
  void check() const;

  std::filesystem::path path_;
  FileMark mark_;
  std::ofstream stream_;
  std::string row_;
};

}  // namespace scarp
