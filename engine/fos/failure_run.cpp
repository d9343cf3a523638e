// SPDX-License-Identifier: BSD-3-Clause
/// A reduced run with frames, ended when enough has moved.

#include "engine/fos/failure_run.hpp"

#include "engine/fos/rate.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/run/run.hpp"

namespace scarp {
namespace {

constexpr double shown_limits = 1.5, shown_windows = 2.0;
/// Soil that moves less than this within the criterion's span has come to rest [limits].
constexpr double still_limits = 0.01;
constexpr std::uint64_t look_steps = 10;

}  // namespace

bool run_failure(StrengthReduction& slope, double reduction, const std::filesystem::path& folder,
                 const Proceed& proceed) {
  const Criterion& criterion = slope.criterion();
  std::optional<Simulation> simulation =
      slope.before_last_cut(reduction, shown_windows * criterion.window, proceed);
  if (!simulation) return false;
  RunWriter writer(*simulation, folder);
  const double still = still_limits * criterion.limit / criterion.span;  // [m/s]
  Rate rate(criterion.span);
  bool goes_on = true;
  const auto after_step = [&](const Simulation& now) {
    if (now.last_step().step % look_steps == 0) {
      rate.sample(now.last_step().stage_time, slope.largest_displacement(now));
      const std::optional<double> moving = rate.value();
      const bool far = slope.displacement(now) > shown_limits * criterion.limit;
      if (far || (moving && *moving < still)) simulation->end_stage();
    }
    goes_on = !proceed || proceed(now);
    return goes_on;
  };
  run(*simulation, {.writer = &writer, .after_step = after_step});
  return goes_on;
}

}  // namespace scarp
