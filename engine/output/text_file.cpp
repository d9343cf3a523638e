// SPDX-License-Identifier: BSD-3-Clause
/// Text files whose every write is checked.

#include "engine/output/text_file.hpp"

#include <fmt/format.h>

#include <system_error>

#include "engine/errors.hpp"

namespace scarp {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw FileError(fmt::format(
      "'{}': cannot be written. Check that the folder exists and may be written, and that the disk "
      "is not full.",
      path.string()));
}

}  // namespace

void replace_file(const std::filesystem::path& path, std::string_view text) {
  std::filesystem::path part = path;
  part += ".part";
  std::ofstream stream(part, std::ios::binary | std::ios::trunc);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  std::error_code error;
  if (!stream) {
    std::filesystem::remove(part, error);
    fail(path);
  }
  std::filesystem::rename(part, path, error);
  if (error) fail(path);
}

CsvFile::CsvFile(std::filesystem::path path, const std::vector<std::string>& header)
    : path_(std::move(path)), stream_(path_, std::ios::binary | std::ios::trunc) {
  check();
  for (const std::string& title : header) *this << title;
  end_row();
}

CsvFile& CsvFile::operator<<(double value) {
  if (!row_.empty()) row_ += ',';
  fmt::format_to(std::back_inserter(row_), "{:.10g}", value);
  return *this;
}

CsvFile& CsvFile::operator<<(std::string_view text) {
  if (!row_.empty()) row_ += ',';
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    row_ += text;
    return *this;
  }
  row_ += '"';
  for (const char c : text) row_.append(c == '"' ? 2 : 1, c);
  row_ += '"';
  return *this;
}

void CsvFile::end_row() {
  row_ += '\n';
  stream_ << row_ << std::flush;
  row_.clear();
  check();
}

void CsvFile::check() const {
  if (!stream_) fail(path_);
}

}  // namespace scarp
