// SPDX-License-Identifier: BSD-3-Clause
/// A reduced run with frames, ended when enough has moved.

#include "engine/fos/failure_run.hpp"

#include "engine/output/run_writer.hpp"
#include "engine/run/run.hpp"

namespace scarp {
namespace {

constexpr double shown_limits = 5.0, shown_windows = 2.0;
constexpr std::uint64_t look_steps = 10;

}  // namespace

void run_failure(const StrengthReduction& slope, double reduction,
                 const std::filesystem::path& folder, const Proceed& proceed) {
  const Criterion& criterion = slope.criterion();
  const std::size_t last = slope.settled().stage_index();
  Simulation simulation = slope.reduced(reduction, shown_windows * criterion.window);
  RunWriter writer(simulation, folder);
  const auto after_step = [&](const Simulation& now) {
    const bool held =
        now.stage_index() + 1 == now.scene().stages.size() && now.stage_index() > last;
    const bool far = held && now.last_step().step % look_steps == 0 &&
                     slope.displacement(now) > shown_limits * criterion.limit;
    if (far) simulation.end_stage();
    return !proceed || proceed(now);
  };
  run(simulation, {.writer = &writer, .after_step = after_step});
}

}  // namespace scarp
