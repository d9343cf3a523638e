// SPDX-License-Identifier: BSD-3-Clause
/// Lets a run that became unstable go back and on with shorter time steps.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/errors.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// Does nothing for a scene without `retry`. States are kept every 500 steps, if they are sound; a
/// run goes back to the last but one, at least that far from what it runs away from. What follows
/// is, bit for bit, what a run from that state with that step would do. The states are part of a
/// checkpoint: a resumed run goes back to the same ones.
class Recovery {
 public:
  /// Keeps the present state. Errors: FileError.
  Recovery(const Simulation& simulation, RunWriter& writer);

  /// Goes on with the states that belong to a checkpoint in `folder`, or as above if it has none.
  /// Errors: CheckpointError if one is missing or damaged; FileError.
  Recovery(const Simulation& simulation, RunWriter& writer, const Snapshot& checkpoint);

  /// Errors: FileError; SimulationInstability if the state to be kept is not sound.
  void after_step(const Simulation& simulation, RunWriter& writer);

  /// Halves the step factor, puts state and outputs back, removes the checkpoints after it. Returns
  /// what to say, or nothing if no retry is left or the time step was not to blame. Errors:
  /// FileError.
  std::optional<std::string> go_back(Simulation& simulation, RunWriter& writer,
                                     const SimulationInstability& instability);

  /// Of the states kept, oldest first.
  std::vector<std::uint64_t> steps() const;

  /// Puts states that are not there yet into the checkpoints of a run's folder. Errors: FileError.
  void write_states(const std::filesystem::path& folder);

 private:
  struct Kept {
    std::uint64_t step = 0;
    Snapshot state;
    bool written = false;
  };
  void keep(const Simulation& simulation, RunWriter& writer);

  bool wanted_;
  std::vector<Kept> kept_;  ///< two at most, oldest first
};

}  // namespace scarp
