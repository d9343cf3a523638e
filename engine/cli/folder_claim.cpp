// SPDX-License-Identifier: BSD-3-Clause
/// What a folder holds, told by the names of its files.
#include "engine/cli/folder_claim.hpp"

#include <optional>
#include <string>

#include <fmt/format.h>

#include "engine/cli/run_record.hpp"
#include "engine/errors.hpp"
#include "engine/output/result_files.hpp"
#include "engine/run/checkpoint_writer.hpp"

namespace scarp::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* ways_out =
    "To replace it: --overwrite. To keep both: another folder with -o.";

bool is_there(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored);
}

/// Whose results these are; nothing if of none of the three.
std::optional<Command> writer_of(const fs::path& folder) {
  if (is_there(folder / "run.json")) return Command::run;
  for (const char* name : {"search.json", "fos.json", "fos.csv"}) {
    if (is_there(folder / name)) return Command::fos;
  }
  if (is_there(folder / "converge.json") || is_there(folder / "converge.csv"))
    return Command::converge;
  return {};
}

/// A study that was stopped has only whole runs in folders of their own.
bool all_in_folders(const fs::path& folder, const std::vector<fs::path>& results) {
  for (const fs::path& path : results) {
    const std::string first = path.lexically_relative(folder).begin()->string();
    if (!first.starts_with("dx_") || first == path.lexically_relative(folder)) return false;
  }
  return true;
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& what) {
  throw FileError(fmt::format("'{}': {} {}", folder.string(), what, ways_out));
}

/// Why a run must not make way for a run of this scene; empty if it may.
std::string why_a_run_stays(const fs::path& folder, const Scene& scene) {
  RunRecord record;
  try {
    record = read_record(folder);
  } catch (const FileError&) {
    return "holds a run whose run.json is damaged.";
  }
  if (!run_has_ended(folder)) {
    return fmt::format(
        "holds a run of '{}' that has not reached its end{}. To go on with it: scarp resume {}.",
        record.scene_name, checkpoints_in(folder).empty() ? " (and has no checkpoint)" : "",
        folder.string());
  }
  if (fs::path(record.scene_name).filename() == fs::path(scene.file).filename()) return {};
  return fmt::format("holds a run of another scene, '{}'.", record.scene_name);
}

const char* name_of(Command command) {
  return command == Command::run ? "run" : command == Command::fos ? "fos" : "converge";
}

}  // namespace

void claim_folder(const fs::path& folder, Command command, const Scene& scene, bool overwrite) {
  const std::vector<fs::path> results = results_in(folder, scene.file);
  if (overwrite) {
    remove_results(folder, scene.file);
    return;
  }
  if (results.empty()) {
    std::error_code ignored;
    const fs::path copy = folder / "scene.toml";
    if (command == Command::run && is_there(copy) && !fs::equivalent(copy, scene.file, ignored))
      refuse(folder, "holds a file 'scene.toml' that is another scene; the run would replace it.");
    return;
  }
  std::optional<Command> writer = writer_of(folder);
  if (!writer && command == Command::converge && all_in_folders(folder, results))
    writer = Command::converge;
  if (writer != command) {
    refuse(folder, writer ? fmt::format("holds the results of 'scarp {}'.", name_of(*writer))
                          : fmt::format("holds results of something else, such as '{}'.",
                                        results.front().lexically_relative(folder).string()));
  }
  if (command == Command::run) {
    if (const std::string why = why_a_run_stays(folder, scene); !why.empty()) refuse(folder, why);
    return;  // `begin_run` and RunWriter take it away
  }
  if (command == Command::fos) return;  // `begin_search` knows whether it is the same
  remove_page(folder);
  for (const char* name : {"converge.json", "converge.csv"}) remove_file(folder / name);
}

}  // namespace scarp::cli
