// SPDX-License-Identifier: BSD-3-Clause
/// run.json: what `scarp run` was asked for, so that `scarp resume` needs the folder alone.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/scene/scene_reader.hpp"

namespace scarp::cli {

struct RunRecord {
  std::string program;     ///< version that began the run
  std::string scene_name;  ///< file it was read from
  std::string scene_text;
  SceneOverrides overrides;
  std::string isa;             ///< in use
  std::optional<int> threads;  ///< asked for; empty: as many as make it faster
};

/// Leaves the folder as that of a run which has not come to its first checkpoint: removes
/// checkpoints and results of an earlier run, then writes run.json. Errors: FileError.
void begin_run(const std::filesystem::path& folder, const RunRecord& record);

/// Writes run.json for a run that goes on with a longer scene. Errors: FileError.
void write_record(const std::filesystem::path& folder, const RunRecord& record);

/// Errors: FileError if the folder holds no run.
RunRecord read_record(const std::filesystem::path& folder);

/// Whether results.json says that the run has reached its end, be it with all its soil or not.
bool run_is_finished(const std::filesystem::path& folder);

/// Whether results.json says that the run lost soil.
bool run_lost_soil(const std::filesystem::path& folder);

/// Whether the run has reached its end or became unstable, which going on would only repeat.
bool run_has_ended(const std::filesystem::path& folder);

/// The first value in which two scenes differ, outputs included, as "spacing = 1, here spacing =
/// 2"; empty if none does.
std::string difference_of(const Scene& recorded, const Scene& here);

/// A sentence if the scene file has become another scene since the run began; empty if it has not,
/// or is no longer there.
std::string change_of_scene(const RunRecord& record, const Scene& recorded);

}  // namespace scarp::cli
