// SPDX-License-Identifier: BSD-3-Clause
/// Lets a run that became unstable go back and on with shorter time steps.
#pragma once

#include <optional>
#include <string>

#include "engine/errors.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// Does nothing for a scene without `retry`. States are kept in memory every 500 steps, if they are
/// sound; a run goes back to the last but one, at least that far from what it runs away from. What
/// follows is, bit for bit, what a run from that state with that step would do.
class Recovery {
 public:
  /// Keeps the present state. Errors: FileError.
  Recovery(const Simulation& simulation, RunWriter& writer);

  /// Errors: FileError; SimulationInstability if the state to be kept is not sound.
  void after_step(const Simulation& simulation, RunWriter& writer);

  /// Halves the step factor, puts state and outputs back, removes the checkpoints after it. Returns
  /// what to say, or nothing if no retry is left or the time step was not to blame. Errors:
  /// FileError.
  std::optional<std::string> go_back(Simulation& simulation, RunWriter& writer,
                                     const SimulationInstability& instability);

 private:
  void keep(const Simulation& simulation, RunWriter& writer);

  bool wanted_;
  std::optional<Snapshot> last_but_one_, last_;
};

}  // namespace scarp
