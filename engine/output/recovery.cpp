// SPDX-License-Identifier: BSD-3-Clause
/// Kept states and the way back.
#include "engine/output/recovery.hpp"

#include <cmath>

#include <fmt/format.h>

#include "engine/output/checkpoint_writer.hpp"

namespace scarp {
namespace {

constexpr std::uint64_t steps_between = 500;

}  // namespace

Recovery::Recovery(const Simulation& simulation, RunWriter& writer)
    : wanted_(simulation.scene().retries > 0) {
  if (wanted_) keep(simulation, writer);
}

void Recovery::keep(const Simulation& simulation, RunWriter& writer) {
  last_but_one_ = std::move(last_);
  last_ = simulation.snapshot();
  writer.add_progress(*last_);
}

void Recovery::after_step(const Simulation& simulation, RunWriter& writer) {
  if (!wanted_ || simulation.last_step().step % steps_between != 0) return;
  simulation.require_sound();
  keep(simulation, writer);
}

std::optional<std::string> Recovery::go_back(Simulation& simulation, RunWriter& writer,
                                             const SimulationInstability& instability) {
  const auto done = static_cast<int>(writer.retries().size());
  if (!wanted_ || done >= simulation.scene().retries) return {};
  if (last_but_one_) last_ = std::move(last_but_one_);
  last_but_one_.reset();
  const std::uint64_t failed = simulation.last_step().step + 1;
  simulation = Simulation(simulation.scene(), *last_, {simulation.threads(), {}});
  simulation.set_step_factor(std::ldexp(1.0, -(done + 1)));
  const std::uint64_t back_to = simulation.last_step().step;
  remove_checkpoints_after(writer.folder(), back_to);
  writer.go_back(simulation, *last_,
                 {failed, back_to, simulation.step_factor(), instability.what()});
  return fmt::format("{}\nRetry {} of {}: back to step {}, with {:g} of the time step.",
                     instability.what(), done + 1, simulation.scene().retries, back_to,
                     simulation.step_factor());
}

}  // namespace scarp
