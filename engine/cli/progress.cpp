// SPDX-License-Identifier: BSD-3-Clause
/// Text and timing of the progress display.

#include "engine/cli/progress.hpp"
#include "engine/plain_text.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace scarp::cli {
namespace {

/// Simulated time of the stages behind, at most [s]: one that ended at rest before its time was up
/// counts in full.
double stages_before(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  double time = 0.0;
  for (std::size_t s = 0; s < std::min(simulation.stage_index(), scene.stages.size()); ++s) {
    time += scene.stages[s].duration.value_or(0.0);
  }
  return time;
}

}  // namespace

Progress::Progress(double total_time, bool quiet)
    : total_time_(total_time), quiet_(quiet), terminal_(isatty(STDERR_FILENO) != 0) {}

void Progress::update(const Simulation& simulation) {
  if (quiet_) return;
  const StepReport& report = simulation.last_step();
  if (time_before_ < 0.0) {
    const double stage_before = std::fmax(report.stage_time - report.time_step, 0.0);
    time_before_ = stages_before(simulation) + stage_before;
    steps_before_ = report.step > 0 ? report.step - 1 : 0;
  }
  const auto now = Clock::now();
  const double pause = terminal_ ? 0.2 : 5.0;
  if (std::chrono::duration<double>(now - last_).count() < pause) return;
  last_ = now;
  const double done = stages_before(simulation) + report.stage_time - time_before_;
  const double total = total_time_ - time_before_;
  const double fraction = total > 0.0 ? std::clamp(done / total, 0.0, 1.0) : 0.0;
  const std::string line =
      text(simulation, std::chrono::duration<double>(now - start_).count(), fraction);
  if (terminal_) {
    constexpr int width = 24;
    const int filled = static_cast<int>(std::lround(fraction * width));
    fmt::print(stderr, "\r\033[K[{:#<{}}{:.<{}}] {}", "", filled, "", width - filled, line);
  } else {
    fmt::print(stderr, "{}\n", line);
  }
  std::fflush(stderr);
  drawn_ = true;
}

std::string Progress::text(const Simulation& simulation, double elapsed, double fraction) const {
  const Scene& scene = simulation.scene();
  const StepReport& report = simulation.last_step();
  const std::size_t stage = simulation.stage_index();
  const double rate = static_cast<double>(simulation.soil_count()) *
                      static_cast<double>(report.step - steps_before_) / std::fmax(elapsed, 1e-9);
  return fmt::format(
      "{:3.0f} %  {:.4g} s  {}  step {} of {:.2g} s ({})  {:.3g} M particle-steps/s  {} left",
      100.0 * fraction, report.time, stage < scene.stages.size() ? scene.stages[stage].name : "-",
      report.step, report.time_step, name_of(report.limit), rate / 1e6,
      fraction > 0.0 ? readable_duration(elapsed * (1.0 - fraction) / fraction)
                     : std::string("unknown time"));
}

void Progress::end() {
  if (terminal_ && drawn_) fmt::print(stderr, "\n");
  drawn_ = false;
}

}  // namespace scarp::cli
