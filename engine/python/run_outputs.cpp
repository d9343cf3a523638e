// SPDX-License-Identifier: BSD-3-Clause
/// What `scarp run` does around its loop.
#include "engine/python/run_outputs.hpp"

#include "engine/cli/folder_claim.hpp"
#include "engine/cli/run_record.hpp"
#include "engine/output/results.hpp"

namespace scarp::python {
namespace {

/// Scenes are read again with the same preset and spacing where a run is resumed.
SceneOverrides overrides_of(const Scene& scene) { return {scene.numerics.preset, scene.spacing}; }

RunWriter begun(const Simulation& simulation, const RunOptions& options,
                const std::filesystem::path& folder, bool overwrite) {
  const Scene& scene = simulation.scene();
  cli::claim_folder(folder, cli::Command::run, scene, overwrite);
  cli::begin_run(folder, {program_version(), scene.file, scene.text, overrides_of(scene),
                          simulation.isa(), options.threads});
  return {simulation, folder};
}

}  // namespace

RunOutputs::RunOutputs(const Simulation& simulation, const RunOptions& options,
                       const std::filesystem::path& folder, bool overwrite)
    : lock_(std::make_unique<FolderLock>(folder)),
      writer_(begun(simulation, options, folder, overwrite)),
      recovery_(simulation, writer_),
      checkpoints_(simulation, writer_, CheckpointWriter::Clock::now, &recovery_) {}

RunOutputs::RunOutputs(const Simulation& simulation, std::unique_ptr<FolderLock> lock,
                       RunWriter writer, Recovery recovery)
    : lock_(std::move(lock)),
      writer_(std::move(writer)),
      recovery_(std::move(recovery)),
      checkpoints_(simulation, writer_, CheckpointWriter::Clock::now, &recovery_) {}

void RunOutputs::join(RunCourse& course) {
  course.writer = &writer_;
  course.checkpoints = &checkpoints_;
  course.recovery = &recovery_;
}

void RunOutputs::finish(const Simulation& simulation, double wall_seconds) {
  writer_.finish(simulation, wall_seconds);
}

}  // namespace scarp::python
