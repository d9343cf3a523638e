// SPDX-License-Identifier: BSD-3-Clause
/// When checkpoints of a run are written, and which are kept.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/output/run_writer.hpp"
#include "engine/run/recovery.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// Checkpoints FOLDER/checkpoints/step_NNNNNNNNNNNN.h5, the newest first. Errors: FileError.
std::vector<std::filesystem::path> checkpoints_in(const std::filesystem::path& folder);

/// Where the checkpoint of a step lies, and the making of that place. Errors: FileError.
std::filesystem::path checkpoint_of(const std::filesystem::path& folder, std::uint64_t step);
void make_checkpoint_folder(const std::filesystem::path& folder);

/// Where the state of a step is kept to go back to; see Recovery.
std::filesystem::path kept_state(const std::filesystem::path& folder, std::uint64_t step);

/// Removes checkpoints and kept states of later steps than this. Errors: FileError.
void remove_checkpoints_after(const std::filesystem::path& folder, std::uint64_t step);

/// Removes the checkpoints of an earlier run. Errors: FileError.
void remove_checkpoints(const std::filesystem::path& folder);

/// Writes a checkpoint whenever `Scene::checkpoints` asks for one, and of the end of the run if it
/// asks for any; keeps the last two. What the checkpoint says has been written by `RunWriter`, and
/// the states that `recovery` would go back to, are on the disk first.
class CheckpointWriter {
 public:
  using Clock = std::chrono::steady_clock;  // not moved when the time of day is set

  /// Removes what a killed run has left half-written; `now` tells `wall_interval` the time. Errors:
  /// FileError.
  CheckpointWriter(const Simulation& simulation, RunWriter& outputs,
                   std::function<Clock::time_point()> now = Clock::now,
                   Recovery* recovery = nullptr);

  /// Call after each step, behind `RunWriter::after_step`. Returns a warning if a checkpoint could
  /// not be written and the scene wants to go on in that case, else nothing. Errors: FileError.
  std::string after_step(const Simulation& simulation);

  /// Writes one now. Errors: FileError; the checkpoints before stay.
  void write(const Simulation& simulation);

  /// The run has gone back to the present state of `simulation`.
  void went_back(const Simulation& simulation);

 private:
  bool due(const Simulation& simulation);

  void remove_old_files();

  RunWriter& outputs_;
  Recovery* recovery_;
  std::vector<std::uint64_t> kept_,
      kept_before_;  ///< states of the last checkpoint, of the one before
  Checkpoints wanted_;
  std::function<Clock::time_point()> now_;
  Clock::time_point last_ = now_();
  double next_ = 0.0;  ///< simulated time [s]
};

}  // namespace scarp
