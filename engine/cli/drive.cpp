// SPDX-License-Identifier: BSD-3-Clause
/// The loop of `scarp run` and `scarp resume`.
#include "engine/cli/drive.hpp"

#include <fmt/format.h>

#include "engine/cli/commands.hpp"
#include "engine/cli/interrupt.hpp"
#include "engine/cli/progress.hpp"
#include "engine/cli/run_record.hpp"
#include "engine/errors.hpp"
#include "engine/output/checkpoint_writer.hpp"
#include "engine/plain_text.hpp"

namespace scarp::cli {
namespace {

void say_how_to_go_on(const RunWriter& writer) {
  fmt::print(stderr, "To go on{}: scarp resume {}\n",
             checkpoints_in(writer.folder()).empty() ? " (from the start)" : "",
             plain_text(writer.folder().string()));
}

}  // namespace

int drive(Simulation& simulation, RunWriter& writer, Recovery recovery,
          const DriveOptions& options) {
  CheckpointWriter checkpoints(simulation, writer, CheckpointWriter::Clock::now, &recovery);
  Progress progress(total_duration(simulation.scene()), options.quiet);
  catch_interrupts();
  const auto say = [&progress](const std::string& words) {
    if (words.empty()) return;
    progress.end();
    fmt::print(stderr, "warning: {}\n", words);
  };
  bool lost = simulation.lost_soil().particles > 0;
  const auto after_step = [&](const Simulation& now) {
    progress.update(now);
    if (!lost && now.lost_soil().particles > 0) {
      lost = true;
      say(now.lost_soil().message(now.soil_count()) + " The run goes on.");
    }
    recovery.after_step(now, writer);
    if (!stop_requested() || now.finished()) {
      say(checkpoints.after_step(now));
      return true;
    }
    try {
      checkpoints.write(now);
    } catch (const FileError& error) {
      say(fmt::format("no checkpoint of the last step: {}", error.what()));
    }
    return false;
  };
  const auto finish = [&] {
    progress.end();
    if (!options.json.empty())
      write_text(options.json, read_text(writer.folder() / "results.json"));
  };
  double wall_seconds = 0.0;
  for (bool again = true; again;) {
    again = false;
    try {
      wall_seconds += run(simulation, &writer, after_step);
    } catch (const SimulationInstability& instability) {
      if (const auto retry = recovery.go_back(simulation, writer, instability)) {
        checkpoints.went_back(simulation);
        say(*retry);
        again = true;
        continue;
      }
      finish();
      fmt::print(stderr, "The run stopped; its last state and {} frames are in {}.\n",
                 writer.frame_count(), plain_text(writer.folder().string()));
      if (const auto good = checkpoints_in(writer.folder()); !good.empty())
        fmt::print(stderr, "The last good state is {}.\n", plain_text(good.front().string()));
      throw;
    } catch (const FileError&) {
      progress.end();
      say_how_to_go_on(writer);
      throw;
    }
  }
  finish();
  if (!options.quiet) {
    fmt::print(stderr, "{} after {} steps, {:.4g} s simulated in {}; results in {}\n",
               simulation.finished() ? "done" : "stopped", simulation.last_step().step,
               simulation.last_step().time, readable_duration(wall_seconds),
               plain_text(writer.folder().string()));
  }
  if (simulation.finished()) {
    const LostSoil& at_end = simulation.lost_soil();
    if (at_end.particles == 0) return ok;
    say(at_end.message(simulation.soil_count()));
    return ExitCode::lost_soil;
  }
  say_how_to_go_on(writer);
  return interrupted;
}

}  // namespace scarp::cli
