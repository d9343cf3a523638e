// SPDX-License-Identifier: BSD-3-Clause
/// Which checkpoint a run goes on from.
#include "engine/cli/resumed_run.hpp"

#include <fmt/format.h>

#include <system_error>
#include <vector>

#include "engine/errors.hpp"
#include "engine/output/checkpoint_file.hpp"
#include "engine/run/checkpoint_writer.hpp"

namespace scarp::cli {
namespace {

namespace fs = std::filesystem;

ResumedRun go_on_from(const fs::path& checkpoint, const RunToResume& run) {
  const Snapshot snapshot = read_checkpoint(checkpoint);
  Simulation simulation(run.scene, snapshot, run.options);
  RunWriter writer(simulation, run.folder, snapshot, run.tables);
  Recovery recovery(simulation, writer, snapshot);
  return {std::move(simulation), std::move(writer), std::move(recovery)};
}

}  // namespace

std::optional<ResumedRun> go_on(const RunToResume& run,
                                const std::function<void(const std::string&)>& warn) {
  const std::vector<fs::path> checkpoints = checkpoints_in(run.folder);
  std::error_code stays;  // such as a folder with something in it
  for (std::size_t k = 0; k < checkpoints.size(); ++k) {
    try {
      ResumedRun resumed = go_on_from(checkpoints[k], run);
      for (std::size_t bad = 0; bad < k; ++bad) fs::remove(checkpoints[bad], stays);
      return resumed;
    } catch (const CheckpointError& error) {
      warn(fmt::format("{}: {}", checkpoints[k].filename().string(), error.what()));
    }
  }
  if (checkpoints.empty()) return {};
  throw CheckpointError(fmt::format(
      "'{}': no checkpoint can be used; the warnings say why. To start over: scarp run {} -o {} "
      "--overwrite",
      run.folder.string(), run.scene.file, run.folder.string()));
}

ResumedRun start_over(const RunToResume& run) {
  Simulation simulation(run.scene, run.options);
  RunWriter writer(simulation, run.folder);
  Recovery recovery(simulation, writer);
  return {std::move(simulation), std::move(writer), std::move(recovery)};
}

}  // namespace scarp::cli
