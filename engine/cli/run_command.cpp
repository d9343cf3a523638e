// SPDX-License-Identifier: BSD-3-Clause
/// `scarp run`: a scene from start to end with all its outputs.

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/cli/commands.hpp"
#include "engine/cli/interrupt.hpp"
#include "engine/cli/progress.hpp"
#include "engine/errors.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/output/text_file.hpp"
#include "engine/scene/scene_reader.hpp"
#include "engine/scene/units.hpp"
#include "engine/scene/warnings.hpp"

namespace scarp::cli {
namespace {

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

double option_value(const std::string& option, const std::string& text, const char* bare_unit,
                    kernels::Unit unit) {
  const bool bare = text.find_first_not_of("0123456789.+-eE") == std::string::npos;
  try {
    return parse_quantity(bare ? text + " " + bare_unit : text, unit);
  } catch (const UnitError& error) {
    throw UsageError(option + ": " + error.what());
  }
}

Scene load_scene(const SceneArguments& arguments) {
  SceneOverrides overrides{arguments.preset, 0.0};
  if (!arguments.spacing.empty()) {
    overrides.spacing = option_value("--spacing", arguments.spacing, "m", kernels::Unit::length);
  }
  return read_scene(arguments.file, overrides);
}

void write_text(const std::string& target, const std::string& text) {
  if (target == "-") {
    fmt::print("{}", text);
  } else {
    replace_file(target, text);
  }
}

int run_command(const RunArguments& arguments) {
  const Scene scene = load_scene(arguments.scene);
  for (const std::string& warning : warnings(scene)) fmt::print(stderr, "warning: {}\n", warning);
  const std::filesystem::path folder =
      arguments.folder.empty()
          ? std::filesystem::path("out") / std::filesystem::path(scene.file).stem()
          : std::filesystem::path(arguments.folder);
  Simulation simulation(scene, arguments.scene.options);
  if (!arguments.quiet) {
    fmt::print(stderr, "{}: {} soil and {} wall particles, {}, {} threads, output in {}\n",
               scene.title.empty() ? arguments.scene.file : scene.title, simulation.soil_count(),
               simulation.wall_count(), simulation.isa(), simulation.threads(), folder.string());
  }
  RunWriter writer(simulation, folder);
  Progress progress(total_duration(scene), arguments.quiet);
  catch_interrupts();
  const auto finish = [&] {
    progress.end();
    if (!arguments.scene.json.empty()) {
      write_text(arguments.scene.json, read_text(folder / "results.json"));
    }
  };
  double wall_seconds = 0.0;
  try {
    wall_seconds = run(simulation, &writer, [&progress](const Simulation& now) {
      progress.update(now);
      return !stop_requested();
    });
  } catch (const SimulationInstability&) {
    finish();
    fmt::print(stderr, "The run stopped; its last state and {} frames are in {}.\n",
               writer.frame_count(), folder.string());
    throw;
  }
  finish();
  if (!arguments.quiet) {
    fmt::print(stderr, "{} after {} steps, {:.4g} s simulated in {}; results in {}\n",
               stop_requested() ? "stopped" : "done", simulation.last_step().step,
               simulation.last_step().time, readable_duration(wall_seconds), folder.string());
  }
  return stop_requested() ? interrupted : ok;
}

}  // namespace scarp::cli
