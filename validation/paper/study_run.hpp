// SPDX-License-Identifier: BSD-3-Clause
/// One run of a study of several: in a folder of its own, able to go on where it was stopped.
#pragma once

#include <functional>
#include <string>

#include "validation/case_run.hpp"
#include "validation/paper/outcome.hpp"

namespace scarp::validation {

struct StudyRun {
  std::string name;    ///< in words
  std::string folder;  ///< below the case's
  Scene scene;
};

/// What is taken from a run. Values a run has put into its outcome survive an interruption.
struct Observer {
  std::function<void(const Simulation&, Outcome&)> each_step;  ///< may be empty
  /// After each step: whether the stage ends here, before its own condition; may be empty.
  std::function<bool(const Simulation&)> stage_is_over;
  /// At the end of each stage; `Simulation::stage_index` says of which.
  std::function<void(const Simulation&, Outcome&)> stage_end;
};

/// Decides whether an outcome belongs to this scene: FNV-1a of the program's version, the scene and
/// its probes.
std::string outcome_key(const Scene& scene);

/// Whether an earlier call has finished this run.
bool is_finished(const CaseRun& run, const StudyRun& study);

/// The outcome of the run. With `CaseOptions::resume` one that an earlier call has finished is
/// read, and one that it had begun goes on from its newest checkpoint that can be used. A run that
/// blows up fails a measure of the case and leaves what it has put into its outcome so far. Errors:
/// SceneError, FileError.
Outcome outcome_of(CaseRun& run, const StudyRun& study, const Observer& observer);

}  // namespace scarp::validation
