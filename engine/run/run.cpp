// SPDX-License-Identifier: BSD-3-Clause
/// The one loop.
#include "engine/run/run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <exception>
#include <optional>

#include "engine/errors.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/run/checkpoint_writer.hpp"
#include "engine/run/recovery.hpp"

namespace scarp {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void warn(const RunCourse& course, const std::string& words) {
  if (course.warn && !words.empty()) course.warn(words);
}

/// The state between two steps, where a run was asked to stop.
void keep_last_step(const Simulation& simulation, const RunCourse& course) {
  if (course.checkpoints == nullptr) return;
  try {
    course.checkpoints->write(simulation);
  } catch (const FileError& error) {
    warn(course, fmt::format("no checkpoint of the last step: {}", error.what()));
  }
}

/// One step and all that belongs to it; false: the caller asked for an early end.
bool advance(Simulation& simulation, const RunCourse& course) {
  try {
    simulation.step();
  } catch (const Stopped&) {
    keep_last_step(simulation, course);
    throw;
  }
  if (course.writer != nullptr) course.writer->after_step(simulation);
  const bool goes_on = !course.after_step || course.after_step(simulation);
  if (course.recovery != nullptr) course.recovery->after_step(simulation, *course.writer);
  if (course.checkpoints != nullptr) warn(course, course.checkpoints->after_step(simulation));
  return goes_on;
}

double run_once(Simulation& simulation, const RunCourse& course) {
  const Clock::time_point start = Clock::now();
  const auto over = [&] { return course.until ? course.until(simulation) : simulation.finished(); };
  bool goes_on = true;
  try {
    while (goes_on && !over()) goes_on = advance(simulation, course);
  } catch (const SimulationInstability& instability) {
    if (course.writer == nullptr) throw;
    const std::string missing =
        course.writer->end_early(simulation, since(start), std::current_exception());
    if (missing.empty()) throw;
    throw SimulationInstability(fmt::format("{}\n{}", instability.what(), missing));
  } catch (...) {
    if (course.writer != nullptr)
      course.writer->end_early(simulation, since(start), std::current_exception());
    throw;
  }
  const double wall_seconds = since(start);
  if (course.writer != nullptr && (!goes_on || !course.until))
    course.writer->finish(simulation, wall_seconds, goes_on ? "" : "stopped on request");
  return wall_seconds;
}

}  // namespace

double run(Simulation& simulation, const RunCourse& course) {
  for (;;) {
    try {
      return run_once(simulation, course);
    } catch (const SimulationInstability& instability) {
      if (course.recovery == nullptr) throw;
      const std::optional<std::string> retry =
          course.recovery->go_back(simulation, *course.writer, instability);
      if (!retry) throw;
      if (course.checkpoints != nullptr) course.checkpoints->went_back(simulation);
      warn(course, *retry);
    }
  }
}

double total_duration(const Scene& scene) {
  double total = 0.0;
  for (const Stage& stage : scene.stages) total += stage.duration.value_or(0.0);
  return total;
}

}  // namespace scarp
