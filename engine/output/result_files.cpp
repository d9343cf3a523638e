// SPDX-License-Identifier: BSD-3-Clause
/// The names of results, in one table.
#include "engine/output/result_files.hpp"

#include <algorithm>
#include <regex>
#include <string>
#include <system_error>

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp {
namespace {

namespace fs = std::filesystem;

enum class Kind { page, output, record };

struct Names {
  Kind kind;
  const char* folder;
  const char* pattern;
};

constexpr Names names[]{
    Names{Kind::page, "", R"(report\.html)"},
    Names{Kind::page, "figures",
          R"((?:probes|walls|energy|history|main|displacement_srf|error_time)\.png)"
          R"(|failure_\w+\.png|\w+_\d{5,9}\.png)"},
    Names{Kind::output, "", R"((?:history|probes|walls|energy)\.csv|results\.json)"},
    Names{Kind::output, "frames", R"((?:soil|walls)(?:_\d{5,9})?\.hdf(?:\.series)?)"},
    Names{Kind::record, "checkpoints", R"((?:step|kept)_\d{12}\.h5)"},
    Names{Kind::record, "", R"((?:run|outcome|fos|search|converge)\.json|(?:fos|converge)\.csv)"},
};

/// Folders in which `scarp fos` and `scarp converge` keep whole runs.
constexpr const char* runs_within = R"(failure|dx_[0-9.e+-]+)";

[[noreturn]] void fail(const fs::path& path, const char* what, const std::error_code& error) {
  throw FileError(fmt::format("'{}': cannot be {}: {}.", path.string(), what, error.message()));
}

std::vector<fs::path> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  if (!fs::is_directory(folder, error)) return found;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error))
    found.push_back(entry->path());
  if (error) fail(folder, "read", error);
  std::sort(found.begin(), found.end());
  return found;
}

/// Whole files and what a killed program has left of one.
void add_matches(const fs::path& folder, const Names& row, std::vector<fs::path>& found) {
  const std::regex ours(fmt::format(R"((?:{})(?:\.part)?)", row.pattern));
  std::error_code ignored;
  for (const fs::path& path : entries_of(folder / row.folder)) {
    if (!fs::is_directory(path, ignored) && std::regex_match(path.filename().string(), ours))
      found.push_back(path);
  }
}

template <class Wanted>
void remove_those(const fs::path& folder, Wanted&& wanted) {
  for (const Names& row : names) {
    if (!wanted(row.kind)) continue;
    std::vector<fs::path> found;
    add_matches(folder, row, found);
    for (const fs::path& path : found) remove_file(path);
  }
}

/// A folder with something else in it stays, and so does a link to one.
void remove_if_empty(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_symlink(folder, ignored) && fs::is_directory(folder, ignored))
    fs::remove(folder, ignored);
}

std::vector<fs::path> folders_of_runs(const fs::path& folder) {
  const std::regex ours(runs_within);
  std::vector<fs::path> found = entries_of(folder);
  std::erase_if(found, [&](const fs::path& path) {
    return !fs::is_directory(path) || !std::regex_match(path.filename().string(), ours);
  });
  return found;
}

}  // namespace

void remove_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) fail(path, "removed", error);
}

std::vector<fs::path> results_in(const fs::path& folder, const fs::path& spared) {
  std::vector<fs::path> found;
  for (const Names& row : names) add_matches(folder, row, found);
  std::error_code ignored;
  if (!found.empty() && fs::exists(folder / "scene.toml", ignored))
    found.push_back(folder / "scene.toml");
  for (const fs::path& run : folders_of_runs(folder)) {
    const std::vector<fs::path> within = results_in(run, spared);
    found.insert(found.end(), within.begin(), within.end());
  }
  std::erase_if(found, [&](const fs::path& path) {
    return !spared.empty() && fs::equivalent(path, spared, ignored);
  });
  return found;
}

void remove_results(const fs::path& folder, const fs::path& spared) {
  for (const fs::path& path : results_in(folder, spared)) remove_file(path);
  for (const fs::path& run : folders_of_runs(folder)) {
    for (const Names& row : names) remove_if_empty(run / row.folder);
    remove_if_empty(run);
  }
  for (const Names& row : names) {
    if (*row.folder != '\0') remove_if_empty(folder / row.folder);
  }
}

void remove_page(const fs::path& folder) {
  remove_those(folder, [](Kind kind) { return kind == Kind::page; });
  remove_if_empty(folder / "figures");
}

void remove_outputs(const fs::path& folder) {
  remove_those(folder, [](Kind kind) { return kind != Kind::record; });
  remove_if_empty(folder / "figures");
}

}  // namespace scarp
