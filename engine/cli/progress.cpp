// SPDX-License-Identifier: BSD-3-Clause
/// From a simulation to the words about it.

#include "engine/cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/plain_text.hpp"

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

Progress::Progress(double total_time, bool quiet, WholeWork whole)
    : line_(quiet), whole_(std::move(whole)), total_time_(total_time) {}

void Progress::update(const Simulation& simulation) {
  const StepReport& report = simulation.last_step();
  if (time_before_ < 0.0) {
    const double stage_before = std::fmax(report.stage_time - report.time_step, 0.0);
    time_before_ = stages_before(simulation) + stage_before;
    steps_before_ = report.step > 0 ? report.step - 1 : 0;
  }
  if (!line_.due()) return;
  const double done = stages_before(simulation) + report.stage_time - time_before_;
  const double total = total_time_ - time_before_;
  const double fraction = total > 0.0 ? std::clamp(done / total, 0.0, 1.0) : 0.0;
  line_.show(fraction, words(simulation, fraction));
}

std::vector<std::string> Progress::words(const Simulation& simulation, double fraction) const {
  const Scene& scene = simulation.scene();
  const StepReport& report = simulation.last_step();
  const std::size_t stage = simulation.stage_index();
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  const double rate = static_cast<double>(simulation.soil_count()) *
                      static_cast<double>(report.step - steps_before_) / std::fmax(elapsed, 1e-9);
  std::vector<std::string> words{fmt::format("{:3.0f} %", 100.0 * fraction)};
  const double left = elapsed * (1.0 - fraction) / fraction;
  words.push_back(fraction > 0.0 ? readable_duration(left) + " left" : "unknown time left");
  if (!whole_.part.empty()) words.push_back(whole_.part);
  if (whole_.ahead && fraction > 0.0) {
    const double all = left + whole_.ahead(elapsed + left);
    words.push_back(readable_duration(all) + " left in all");
  }
  words.push_back(fmt::format("{:.4g} s", report.time));
  words.push_back(stage < scene.stages.size() ? plain_text(scene.stages[stage].name) : "-");
  words.push_back(fmt::format("step {} of {:.2g} s ({})", report.step, report.time_step,
                              name_of(report.limit)));
  words.push_back(fmt::format("{:.3g} M particle-steps/s", rate / 1e6));
  return words;
}

}  // namespace scarp::cli
