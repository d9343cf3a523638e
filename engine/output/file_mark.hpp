// SPDX-License-Identifier: BSD-3-Clause
/// What a file held when a checkpoint was written: its size and a sum over its bytes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/checkpoint/snapshot.hpp"

namespace scarp {

struct FileMark {
  std::uintmax_t bytes = 0;
  std::uint32_t sum = 0;  ///< CRC-32
};

/// With more bytes behind those that `mark` is of.
void extend(FileMark& mark, std::string_view more);

/// Of the first `bytes` of a file, or of all. Nothing if it is no plain file, cannot be read or is
/// shorter. Reads through a small buffer.
std::optional<FileMark> mark_of(const std::filesystem::path& path,
                                std::optional<std::uintmax_t> bytes = {});

/// Why the file is not the one marked: "is gone", "has 12 bytes instead of 3400", "has other
/// bytes". Empty if it is, or has its size and `sizes_only`.
std::string difference_from(const std::filesystem::path& path, const FileMark& mark,
                            bool sizes_only = false);

/// As an item of a snapshot, and back. Errors: CheckpointError if it is not there.
void add_mark(Snapshot& snapshot, std::string item, const FileMark& mark);
FileMark mark_from(const Snapshot& snapshot, const std::string& item);

}  // namespace scarp
