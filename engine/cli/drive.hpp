// SPDX-License-Identifier: BSD-3-Clause
/// From a simulation at its start, or where it was left, to its end.
#pragma once

#include <string>

#include "engine/output/recovery.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/simulation.hpp"

namespace scarp::cli {

struct DriveOptions {
  std::string json;  ///< where to write the numbers, "-" for standard output; empty: nowhere
  bool quiet = false;
};

/// Steps with outputs, progress and checkpoints; a signal ends it with a checkpoint. Returns the
/// exit code. Errors: SimulationInstability, FileError; both after saying how to go on.
int drive(Simulation& simulation, RunWriter& writer, Recovery recovery,
          const DriveOptions& options);

}  // namespace scarp::cli
