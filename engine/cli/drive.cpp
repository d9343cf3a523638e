// SPDX-License-Identifier: BSD-3-Clause
/// What `scarp run` and `scarp resume` say while a run goes, and how they end.
#include "engine/cli/drive.hpp"

#include <fmt/format.h>

#include <chrono>

#include "engine/cli/commands.hpp"
#include "engine/cli/progress.hpp"
#include "engine/cli/run_record.hpp"
#include "engine/errors.hpp"
#include "engine/plain_text.hpp"
#include "engine/run/checkpoint_writer.hpp"
#include "engine/run/run.hpp"

namespace scarp::cli {

int drive(Simulation& simulation, RunWriter& writer, Recovery recovery,
          const DriveOptions& options) {
  CheckpointWriter checkpoints(simulation, writer, CheckpointWriter::Clock::now, &recovery);
  Progress progress(total_duration(simulation.scene()), options.quiet);
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
    return true;
  };
  const auto hand_over = [&] {
    progress.end();
    const std::string results = read_text(writer.folder() / "results.json");
    if (!options.json.empty() && !results.empty()) write_text(options.json, results);
  };
  const auto summary = [&](const char* how, double wall_seconds) {
    if (options.quiet) return;
    fmt::print(stderr, "{} after {} steps, {:.4g} s simulated in {}; results in {}\n", how,
               simulation.last_step().step, simulation.last_step().time,
               readable_duration(wall_seconds), plain_text(writer.folder().string()));
  };
  const auto began = std::chrono::steady_clock::now();
  const auto seconds = [began] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  };
  try {
    run(simulation, {.writer = &writer,
                     .checkpoints = &checkpoints,
                     .recovery = &recovery,
                     .after_step = after_step,
                     .warn = say});
    hand_over();
    summary("done", seconds());
    const LostSoil& at_end = simulation.lost_soil();
    if (at_end.particles == 0) return ok;
    say(at_end.message(simulation.soil_count()));
    return ExitCode::lost_soil;
  } catch (const SimulationInstability&) {
    try {
      hand_over();
    } catch (const FileError& error) {
      say(error.what());
    }
    fmt::print(stderr, "The run stopped; its last state and {} frames are in {}.\n",
               writer.frame_count(), plain_text(writer.folder().string()));
    throw;
  } catch (const Stopped&) {
    hand_over();
    summary("stopped", seconds());
    throw;
  } catch (...) {
    progress.end();
    throw;
  }
}

int saying_how_to_go_on(const std::filesystem::path& folder, const std::function<int()>& work) {
  try {
    return work();
  } catch (const SimulationInstability&) {
    if (const auto good = checkpoints_in(folder); !good.empty())
      fmt::print(stderr, "The last good state is {}.\n", plain_text(good.front().string()));
    throw;
  } catch (...) {
    if (!run_is_finished(folder)) {
      fmt::print(stderr, "To go on{}: scarp resume {}\n",
                 checkpoints_in(folder).empty() ? " (from the start)" : "",
                 plain_text(folder.string()));
    }
    throw;
  }
}

}  // namespace scarp::cli
