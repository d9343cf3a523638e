// SPDX-License-Identifier: BSD-3-Clause
/// The loop that drives a run: steps, outputs, checkpoints, retries.
#pragma once

#include <functional>
#include <string>

#include "engine/simulation.hpp"

namespace scarp {

class CheckpointWriter;
class Recovery;
class RunWriter;

/// What goes along with the steps of a run; what is left out does not take part.
struct RunCourse {
  RunWriter* writer = nullptr;              ///< of all outputs
  CheckpointWriter* checkpoints = nullptr;  ///< needs a writer
  Recovery* recovery = nullptr;             ///< needs a writer
  /// Looked at before each step; empty: the last stage has ended.
  std::function<bool(const Simulation&)> until = {};
  /// Called after each step and its outputs: the place for progress, samples and rules of one's
  /// own. False ends the run early, with its outputs finished and marked incomplete.
  std::function<bool(const Simulation&)> after_step = {};
  /// Hears in words of what the run goes on in spite of: a checkpoint that could not be written, a
  /// retry.
  std::function<void(const std::string&)> warn = {};
};

/// Steps until the course says so; returns the wall time of the steps since the last retry [s]. The
/// outputs of a run that comes to the end of its last stage, or is ended early, are finished. Asked
/// to stop by `RunOptions::stop` it writes a checkpoint. An instability goes to `recovery` first.
/// Errors: those of `Simulation::step()`, of the course's parts and of `after_step`, after
/// `RunWriter::end_early`.
double run(Simulation& simulation, const RunCourse& course = {});

/// Longest simulated time of all stages that have a limit [s].
double total_duration(const Scene& scene);

}  // namespace scarp
