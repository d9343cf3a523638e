// SPDX-License-Identifier: BSD-3-Clause
/// Text files whose every write is checked.

#include "engine/output/text_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include "engine/errors.hpp"

namespace scarp {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path) {
  throw FileError(fmt::format(
      "'{}': cannot be written. Check that the folder exists and may be written, and that the disk "
      "is not full.",
      path.string()));
}
[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw FileError(
      fmt::format("'{}': cannot be written: {}. Check that the folder exists and may be written, "
                  "and that the disk is not full.",
                  path.string(), std::generic_category().message(error)));
}

class Descriptor {
 public:
  Descriptor(const std::filesystem::path& path, int flags)
      : path_(path), number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {
    if (number_ < 0) fail(path_, errno);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  int get() const { return number_; }
  int close() { return number_ < 0 ? 0 : ::close(std::exchange(number_, -1)); }
  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = ::write(number_, text.data(), text.size());
      if (written < 0 && errno != EINTR) fail(path_, errno);
      if (written > 0) text.remove_prefix(static_cast<std::size_t>(written));
    }
  }

 private:
  std::filesystem::path path_;
  int number_;
};

/// Through a new file beside it. Whatever lies at its name, a link that leads elsewhere above all,
/// is removed and not written through; a folder there stays and is an error.
void replace(const std::filesystem::path& path, std::span<const std::string_view> parts,
             bool durably) {
  std::filesystem::path part = path;
  part += ".part";
  ::unlink(part.c_str());
  try {
    Descriptor file(part, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
    for (const std::string_view text : parts) file.write(text);
    if (durably && ::fsync(file.get()) != 0) fail(path, errno);
    if (file.close() != 0) fail(path, errno);
    if (std::rename(part.c_str(), path.c_str()) != 0) fail(path, errno);
  } catch (const FileError&) {
    ::unlink(part.c_str());
    throw;
  }
}

std::filesystem::path end_of_links(std::filesystem::path path) {
  constexpr int most = 40;  // as the system allows
  std::error_code error;
  for (int k = 0; k < most && std::filesystem::is_symlink(path, error); ++k)
    path = path.parent_path() / std::filesystem::read_symlink(path, error);  // may be absolute
  return path;
}

}  // namespace

void replace_file(const std::filesystem::path& path, std::string_view text) {
  replace(path, std::array{text}, false);
}

void write_to_target(const std::filesystem::path& target, std::string_view text) {
  std::error_code error;
  const std::filesystem::file_status found = std::filesystem::status(target, error);
  if (std::filesystem::exists(found) && !std::filesystem::is_regular_file(found)) {
    Descriptor stream(target, O_WRONLY);
    stream.write(text);
    if (stream.close() != 0) fail(target, errno);
    return;
  }
  replace_file(end_of_links(target), text);
}

void make_output_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return;
  throw FileError(fmt::format("'{}': cannot be made as output folder: {}. Try another with -o.",
                              folder.string(), error.message()));
}

void flush_to_disk(const std::filesystem::path& path) {
  const Descriptor file(path, O_RDONLY);
  if (::fsync(file.get()) != 0) fail(path, errno);
}

void replace_file_durably(const std::filesystem::path& path,
                          std::span<const std::string_view> parts) {
  replace(path, parts, true);
  flush_to_disk(path.parent_path());
}

CsvFile::CsvFile(std::filesystem::path path, const FileMark& mark)
    : path_(std::move(path)), mark_(mark) {
  const std::optional<FileMark> present = mark_of(path_, mark.bytes);
  if (!present || present->sum != mark.sum) {
    throw CheckpointError(fmt::format(
        "'{}': its first {} bytes are {}, and the run goes on behind them. Try the checkpoint "
        "before it, or `scarp resume --accept-tables`.",
        path_.string(), mark.bytes, present ? "not those that were written" : "not all there"));
  }
  std::error_code error;
  std::filesystem::resize_file(path_, mark.bytes, error);
  if (error) fail(path_, error.value());
  stream_.open(path_, std::ios::binary | std::ios::app);
  check();
}

CsvFile CsvFile::as_it_is(std::filesystem::path path, std::uintmax_t most,
                          const std::vector<std::string>& header) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {std::move(path), header};
  std::ifstream stream(path, std::ios::binary);
  FileMark mark;
  for (std::string row; std::getline(stream, row) && !stream.eof();) {
    row += '\n';
    if (mark.bytes + row.size() > most) break;
    extend(mark, row);
  }
  stream.close();
  if (mark.bytes == 0) return {std::move(path), header};
  return {std::move(path), mark};
}

FileMark CsvFile::flushed() const {
  flush_to_disk(path_);
  return mark_;
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
  extend(mark_, row_);
  row_.clear();
  check();
}

void CsvFile::check() const {
  if (!stream_) fail(path_);
}

}  // namespace scarp
