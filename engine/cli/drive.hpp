// SPDX-License-Identifier: BSD-3-Clause
/// From a simulation at its start, or where it was left, to its end.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "engine/output/run_writer.hpp"
#include "engine/run/recovery.hpp"
#include "engine/simulation.hpp"

namespace scarp::cli {

struct DriveOptions {
  std::string json;  ///< where to write the numbers, "-" for standard output; empty: nowhere
  bool quiet = false;
};

/// Steps with outputs, progress and checkpoints; asked to stop it leaves a checkpoint. Returns the
/// exit code. Errors: those of `run`.
int drive(Simulation& simulation, RunWriter& writer, Recovery recovery,
          const DriveOptions& options);

/// Calls `work` on the run of a folder; whatever it throws, a line says how that run goes on.
int saying_how_to_go_on(const std::filesystem::path& folder, const std::function<int()>& work);

}  // namespace scarp::cli
