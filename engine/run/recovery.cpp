// SPDX-License-Identifier: BSD-3-Clause
/// Kept states and the way back.
#include "engine/run/recovery.hpp"

#include <cmath>

#include <fmt/format.h>

#include "engine/output/checkpoint_file.hpp"
#include "engine/run/checkpoint_writer.hpp"

namespace scarp {
namespace {

constexpr std::uint64_t steps_between = 500;
constexpr std::size_t states_kept = 2;

}  // namespace

Recovery::Recovery(const Simulation& simulation, RunWriter& writer)
    : wanted_(simulation.scene().retries > 0) {
  if (wanted_) keep(simulation, writer);
}

Recovery::Recovery(const Simulation& simulation, RunWriter& writer, const Snapshot& checkpoint)
    : wanted_(simulation.scene().retries > 0) {
  if (!wanted_) return;
  for (const std::int64_t step : checkpoint.integers("retry/kept_steps")) {
    const auto of = static_cast<std::uint64_t>(step);
    kept_.push_back({of, read_checkpoint(kept_state(writer.folder(), of)), true});
  }
  if (kept_.empty()) keep(simulation, writer);  // begun without `retry`
}

void Recovery::keep(const Simulation& simulation, RunWriter& writer) {
  Kept now{simulation.last_step().step, simulation.snapshot(), false};
  writer.add_progress(now.state);
  if (kept_.size() == states_kept) kept_.erase(kept_.begin());
  kept_.push_back(std::move(now));
}

std::vector<std::uint64_t> Recovery::steps() const {
  std::vector<std::uint64_t> steps;
  for (const Kept& kept : kept_) steps.push_back(kept.step);
  return steps;
}

void Recovery::write_states(const std::filesystem::path& folder) {
  for (Kept& kept : kept_) {
    if (!kept.written) write_checkpoint(kept_state(folder, kept.step), kept.state);
    kept.written = true;
  }
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
  kept_.resize(1);
  const Snapshot& state = kept_.front().state;
  const std::uint64_t failed = simulation.last_step().step + 1;
  simulation = Simulation(simulation.scene(), state, simulation.options());
  simulation.set_step_factor(std::ldexp(1.0, -(done + 1)));
  const std::uint64_t back_to = simulation.last_step().step;
  remove_checkpoints_after(writer.folder(), back_to);
  writer.go_back(simulation, state,
                 {failed, back_to, simulation.step_factor(), instability.what()});
  std::string frames_left_out;
  for (const std::string& warning : writer.warnings()) frames_left_out += '\n' + warning;
  return fmt::format("{}\nRetry {} of {}: back to step {}, with {:g} of the time step.{}",
                     instability.what(), done + 1, simulation.scene().retries, back_to,
                     simulation.step_factor(), frames_left_out);
}

}  // namespace scarp
