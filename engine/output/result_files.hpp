// SPDX-License-Identifier: BSD-3-Clause
/// Which files of a folder are scarp's own results, so that they can be found and removed.
#pragma once

#include <filesystem>
#include <vector>

namespace scarp {

/// What the commands have left in a folder by the names they give (`engine/output/FORMATS.md`):
/// tables, frames, checkpoints, records, pages, and the copy of the scene beside any of them. Not
/// `spared`, nor what only lies beside them. Errors: FileError.
std::vector<std::filesystem::path> results_in(const std::filesystem::path& folder,
                                              const std::filesystem::path& spared = {});

/// Removes what `results_in` names, and folders that have become empty by it. Errors: FileError.
void remove_results(const std::filesystem::path& folder, const std::filesystem::path& spared = {});

/// Removes report.html and its figures, which would speak of an earlier run. Errors: FileError.
void remove_page(const std::filesystem::path& folder);

/// Removes page, results.json, tables and frames; record, checkpoints and scene stay. Errors:
/// FileError.
void remove_outputs(const std::filesystem::path& folder);

/// Errors: FileError.
void remove_file(const std::filesystem::path& path);

}  // namespace scarp
