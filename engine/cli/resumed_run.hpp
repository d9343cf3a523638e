// SPDX-License-Identifier: BSD-3-Clause
/// A run that goes on from its newest checkpoint that is whole.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "engine/output/run_writer.hpp"
#include "engine/run/recovery.hpp"
#include "engine/simulation.hpp"

namespace scarp::cli {

/// What a run goes on with.
struct RunToResume {
  std::filesystem::path folder;
  Scene scene;
  RunOptions options;
  OldTables tables = OldTables::as_recorded;
};

struct ResumedRun {
  Simulation simulation;
  RunWriter writer;
  Recovery recovery;
};

/// From the newest checkpoint that can be used; those that cannot are removed, since later ones
/// would count as older, and `warn` hears why. Nothing if there is none at all. Pre: the folder's
/// lock is held. Errors: CheckpointError if none is good.
std::optional<ResumedRun> go_on(const RunToResume& run,
                                const std::function<void(const std::string&)>& warn);

/// From the start.
ResumedRun start_over(const RunToResume& run);

}  // namespace scarp::cli
