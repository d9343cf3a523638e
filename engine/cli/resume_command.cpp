// SPDX-License-Identifier: BSD-3-Clause
/// `scarp resume`: a run goes on from its newest checkpoint that is whole.

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "engine/cli/commands.hpp"
#include "engine/cli/drive.hpp"
#include "engine/cli/run_record.hpp"
#include "engine/errors.hpp"
#include "engine/output/checkpoint_file.hpp"
#include "engine/output/checkpoint_writer.hpp"
#include "engine/output/folder_lock.hpp"
#include "engine/output/results.hpp"

namespace scarp::cli {
namespace {

namespace fs = std::filesystem;

struct Resumed {
  Simulation simulation;
  RunWriter writer;
};

Resumed go_on_from(const fs::path& checkpoint, const Scene& scene, const RunOptions& options,
                   const fs::path& folder) {
  const Snapshot snapshot = read_checkpoint(checkpoint);
  Simulation simulation(scene, snapshot, options);
  RunWriter writer(simulation, folder, snapshot);
  return {std::move(simulation), std::move(writer)};
}

/// From the newest checkpoint that can be used; those that cannot are removed, since later ones
/// would count as older. Nothing if there is none at all. Errors: CheckpointError if none is good.
std::optional<Resumed> go_on(const Scene& scene, const RunOptions& options,
                             const fs::path& folder) {
  const std::vector<fs::path> checkpoints = checkpoints_in(folder);
  for (std::size_t k = 0; k < checkpoints.size(); ++k) {
    try {
      Resumed resumed = go_on_from(checkpoints[k], scene, options, folder);
      for (std::size_t bad = 0; bad < k; ++bad) fs::remove(checkpoints[bad]);
      return resumed;
    } catch (const CheckpointError& error) {
      fmt::print(stderr, "warning: {}: {}\n", checkpoints[k].filename().string(), error.what());
    }
  }
  if (checkpoints.empty()) return {};
  throw CheckpointError(fmt::format(
      "'{}': no checkpoint can be used; the warnings say why. To start over: scarp run.",
      folder.string()));
}

Resumed start_over(const Scene& scene, const RunOptions& options, const fs::path& folder) {
  Simulation simulation(scene, options);
  RunWriter writer(simulation, folder);
  return {std::move(simulation), std::move(writer)};
}

/// The run has its scene from the record; who has edited a file may believe otherwise.
void say_what_has_changed(const RunRecord& record, const Scene& scene, const fs::path& folder) {
  if (const std::string change = change_of_scene(record, scene); !change.empty()) {
    fmt::print(stderr,
               "warning: {} Here goes on the scene that the run began with. To run the other: "
               "scarp run {} -o {} --overwrite\n",
               change, record.scene_name, folder.string());
  }
  const fs::path copy = folder / "scene.toml";
  std::error_code ignored;
  const bool own = fs::equivalent(copy, record.scene_name, ignored);
  if (own || !fs::exists(copy, ignored) || read_text(copy) == record.scene_text) return;
  const fs::path aside = folder / "scene_edited.toml";
  fs::rename(copy, aside, ignored);
  fmt::print(stderr,
             "warning: '{}' was not the scene of this run; it is now '{}', and changes nothing.\n",
             copy.string(), aside.string());
}

}  // namespace

int resume_command(const ResumeArguments& arguments) {
  const fs::path folder(arguments.folder);
  const RunRecord record = read_record(folder);
  const FolderLock lock(folder);
  const Scene scene = read_scene_text(record.scene_text, record.scene_name, record.overrides);
  say_what_has_changed(record, scene, folder);
  if (run_is_complete(folder)) {
    fmt::print(stderr, "{}: the run is complete; there is nothing to go on with.\n",
               folder.string());
    return ok;
  }
  if (record.program != program_version()) {
    fmt::print(stderr, "warning: begun by scarp {}, which may not give the same bits as {}.\n",
               record.program, program_version());
  }
  RunOptions options = arguments.options;
  if (options.isa.empty()) options.isa = record.isa;
  if (options.threads == 0) options.threads = record.threads;
  std::optional<Resumed> resumed = go_on(scene, options, folder);
  const bool over = !resumed;
  if (over) resumed.emplace(start_over(scene, options, folder));
  if (!arguments.quiet) {
    const StepReport& last = resumed->simulation.last_step();
    fmt::print(stderr, "{}: {} at step {}, {:.4g} s, {}, {} threads\n", folder.string(),
               over ? "no checkpoint, starts over" : "goes on", last.step, last.time,
               resumed->simulation.isa(), resumed->simulation.threads());
  }
  return drive(resumed->simulation, resumed->writer, {arguments.json, arguments.quiet});
}

}  // namespace scarp::cli
