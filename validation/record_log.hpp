// SPDX-License-Identifier: BSD-3-Clause
/// What each run gave, kept line by line so that a later call goes on where an earlier one ended.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace scarp::validation {

/// JSON has no NaN: null stands for it, both ways.
double number_or_nan(const nlohmann::ordered_json& json);

/// Objects of the lines of a file; lines that cannot be read, such as the last one of a killed
/// call, count as not there, and a line that was cut short is ended. Errors: FileError if the file
/// cannot be appended to.
std::vector<nlohmann::ordered_json> open_lines(const std::filesystem::path& path);

/// Appends an object as a line and flushes. Errors: FileError.
void append_line(const std::filesystem::path& path, const nlohmann::ordered_json& object);

/// A JSON-lines file of records by their `key`. Record needs json_of(record) and
/// read(json, record), which is false or throws a JSON exception where the object is none.
template <class Record>
class RecordLog {
 public:
  /// Reads what is there. Errors: FileError if it cannot be appended to.
  explicit RecordLog(std::filesystem::path path) : path_(std::move(path)) {
    for (const nlohmann::ordered_json& json : open_lines(path_)) {
      Record record;
      try {
        if (read(json, record)) records_[record.key] = record;
      } catch (const nlohmann::ordered_json::exception&) {
        continue;
      }
    }
  }

  const Record* find(const std::string& key) const {
    const auto found = records_.find(key);
    return found == records_.end() ? nullptr : &found->second;
  }

  /// Errors: FileError.
  void append(const Record& record) {
    append_line(path_, json_of(record));
    records_[record.key] = record;
  }

 private:
  std::filesystem::path path_;
  std::map<std::string, Record> records_;
};

}  // namespace scarp::validation
