// SPDX-License-Identifier: BSD-3-Clause
/// The folder of a run that Python drives: the same as that of `scarp run`.
#pragma once

#include <filesystem>
#include <memory>

#include "engine/output/folder_lock.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/run/checkpoint_writer.hpp"
#include "engine/run/recovery.hpp"
#include "engine/run/run.hpp"

namespace scarp::python {

class RunOutputs {
 public:
  /// Leaves the folder with the initial state. Pre: no step has been taken. Errors: FileError.
  RunOutputs(const Simulation& simulation, const RunOptions& options,
             const std::filesystem::path& folder, bool overwrite);
  /// Goes on with those of a run that was resumed under this lock. Errors: FileError.
  RunOutputs(const Simulation& simulation, std::unique_ptr<FolderLock> lock, RunWriter writer,
             Recovery recovery);
  RunOutputs(const RunOutputs&) = delete;
  RunOutputs& operator=(const RunOutputs&) = delete;

  void join(RunCourse& course);
  /// The run has come to its end. Errors: FileError.
  void finish(const Simulation& simulation, double wall_seconds);
  const std::filesystem::path& folder() const { return writer_.folder(); }

 private:
  std::unique_ptr<FolderLock> lock_;
  RunWriter writer_;
  Recovery recovery_;
  CheckpointWriter checkpoints_;
};

}  // namespace scarp::python
