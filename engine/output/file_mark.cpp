// SPDX-License-Identifier: BSD-3-Clause
/// Sums of files by zlib.
#include "engine/output/file_mark.hpp"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <system_error>
#include <vector>

#include <fmt/format.h>

namespace scarp {

void extend(FileMark& mark, std::string_view more) {
  mark.bytes += more.size();
  mark.sum = static_cast<std::uint32_t>(
      crc32_z(mark.sum, reinterpret_cast<const Bytef*>(more.data()), more.size()));
}

void add_mark(Snapshot& snapshot, std::string item, const FileMark& mark) {
  snapshot.add(std::move(item),
               std::vector<std::int64_t>{static_cast<std::int64_t>(mark.bytes), mark.sum});
}

FileMark mark_from(const Snapshot& snapshot, const std::string& item) {
  const std::vector<std::int64_t>& stored = snapshot.integers(item, 2);
  return {static_cast<std::uintmax_t>(stored[0]), static_cast<std::uint32_t>(stored[1])};
}

std::optional<FileMark> mark_of(const std::filesystem::path& path,
                                std::optional<std::uintmax_t> bytes) {
  constexpr std::uintmax_t piece = 1 << 20;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return {};  // a pipe would not answer
  std::ifstream stream(path, std::ios::binary);
  std::vector<char> buffer(piece);
  FileMark mark;
  const std::uintmax_t wanted = bytes.value_or(std::numeric_limits<std::uintmax_t>::max());
  while (stream && mark.bytes < wanted) {
    const std::uintmax_t next = std::min(piece, wanted - mark.bytes);
    stream.read(buffer.data(), static_cast<std::streamsize>(next));
    extend(mark, {buffer.data(), static_cast<std::size_t>(stream.gcount())});
  }
  if (stream.bad() || !stream.is_open() || (bytes && mark.bytes < *bytes)) return {};
  return mark;
}

std::string difference_from(const std::filesystem::path& path, const FileMark& mark,
                            bool sizes_only) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return "is gone";
  if (!std::filesystem::is_regular_file(status)) return "is no plain file";
  const std::uintmax_t present = std::filesystem::file_size(path, error);
  if (error) return "cannot be read";
  if (present != mark.bytes) return fmt::format("has {} bytes instead of {}", present, mark.bytes);
  if (sizes_only) return {};
  const std::optional<FileMark> now = mark_of(path);
  if (!now) return "cannot be read";
  return now->sum == mark.sum ? std::string{} : "has other bytes than were written";
}

}  // namespace scarp
