// SPDX-License-Identifier: BSD-3-Clause
/// All outputs of one run in one folder.
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "engine/output/frame_writer.hpp"
#include "engine/output/probe_writer.hpp"
#include "engine/output/results.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// Writes into a folder: frames/ (see FrameWriter), the tables of ProbeWriter, scene.toml (the
/// scene as read, before any override), results.json. Frames and table rows fall on the
/// first step at or after each multiple of the scene's intervals in stage time, and on the first
/// and last step of a stage. Where the scene sets no interval for rows, at least so many steps lie
/// between two that they take about a tenth of the time at most.
class RunWriter {
 public:
  /// Removes outputs and page of an earlier run, then writes the initial state. Errors: FileError.
  RunWriter(const Simulation& simulation, std::filesystem::path folder);

  /// Goes on with the outputs of a run of which `progress` is a snapshot, as if it had never
  /// stopped: what was written later is taken back. Errors: FileError; CheckpointError if rows that
  /// had been written are not there as they were, and `tables` does not accept that.
  RunWriter(const Simulation& simulation, std::filesystem::path folder, const Snapshot& progress,
            OldTables tables = OldTables::as_recorded);

  /// Call after each step. Errors: FileError.
  void after_step(const Simulation& simulation);

  /// Writes the last state, unless that has been done, and results.json; `failure` says why the run
  /// did not reach its end. Errors: FileError.
  void finish(const Simulation& simulation, double wall_seconds, const std::string& failure = {});

  /// The end of every run that came to none of its own, whatever was thrown: as much of the last
  /// state as can be written, and results.json that says why. Returns what could not be written, in
  /// words; empty if all was.
  std::string end_early(const Simulation& simulation, double wall_seconds,
                        const std::exception_ptr& why) noexcept;

  /// Takes back what was written since `progress` was a snapshot, and goes on from there with
  /// `simulation`; the retry stands in the results. Errors: FileError.
  void go_back(const Simulation& simulation, const Snapshot& progress, Retry retry);
  const std::vector<Retry>& retries() const { return results_.retries; }

  /// Replaces the basic measures that `finish` writes (a validation case has its own).
  void set_measures(std::vector<Measure> measures) {
    results_.measures = std::move(measures);
    has_own_measures_ = true;
  }

  /// Flushes everything to the disk and adds how far the outputs have come. Errors: FileError.
  void add_progress(Snapshot& snapshot);

  /// Counts wall time of checkpoints among that of the outputs [s].
  void add_checkpoint_time(double seconds) { checkpoint_seconds_ += seconds; }

  const std::filesystem::path& folder() const { return folder_; }
  /// Of the frames that the run goes on without.
  std::vector<std::string> warnings() const {
    return frames_ ? frames_->warnings() : std::vector<std::string>{};
  }
  std::size_t frame_count() const { return frames_ ? frames_->count() : 0; }

 private:
  void enter_stage(const Simulation& simulation);
  double seconds_so_far() const;  ///< wall time since the run began
  void write_frame(const Simulation& simulation, std::string_view event);
  void write_row(const Simulation& simulation);
  void take_measures(const Simulation& simulation);
  void write_results(const Simulation& simulation, double wall_seconds);

  std::filesystem::path folder_;
  std::optional<FrameWriter> frames_;
  ProbeWriter histories_;
  RunResults results_;  ///< as they come together
  bool has_own_measures_ = false;
  std::size_t stage_ = 0;
  double frame_interval_ = 0.0, row_interval_ = 0.0;  ///< [s]; infinite: none between start and end
  double next_frame_ = 0.0, next_row_ = 0.0;          ///< in stage time [s]
  std::uint64_t steps_between_rows_ = 1;              ///< at least
  std::optional<std::uint64_t> frame_step_, row_step_;
  double seconds_before_ = 0.0;  ///< wall time that the run took before it was resumed
  double frame_seconds_ = 0.0, row_seconds_ = 0.0, checkpoint_seconds_ = 0.0;  ///< wall time
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace scarp
