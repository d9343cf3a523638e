// SPDX-License-Identifier: BSD-3-Clause
/// A snapshot as an HDF5 file of which every byte is checked.
#pragma once

#include <filesystem>

#include "engine/checkpoint/snapshot.hpp"

namespace scarp {

/// Writes PATH.part, flushes it to the disk and renames it, so that PATH is always complete, after
/// a power cut too; a failed write leaves what was at PATH. Takes the file's size in memory, no
/// more where the snapshot is moved in: each item goes once it is in the file. Every item is a
/// dataset with fletcher32 and its unit as attribute; a line with the CRC-32 of all bytes before it
/// ends the file. Format: `engine/output/FORMATS.md`. Errors: FileError.
void write_checkpoint(const std::filesystem::path& path, Snapshot snapshot);

/// How large the file would be [bytes].
std::size_t checkpoint_bytes(Snapshot snapshot);

/// Errors: CheckpointError, saying why: missing, empty, cut short, damaged, of another program or
/// version. HDF5 sees no byte before the sum has been found right.
Snapshot read_checkpoint(const std::filesystem::path& path);

}  // namespace scarp
