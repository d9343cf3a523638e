// SPDX-License-Identifier: BSD-3-Clause
/// `scarp run`: a scene from start to end with all its outputs.

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/check/start_warnings.hpp"
#include "engine/check/warnings.hpp"
#include "engine/cli/commands.hpp"
#include "engine/cli/drive.hpp"
#include "engine/cli/folder_claim.hpp"
#include "engine/cli/run_record.hpp"
#include "engine/output/folder_lock.hpp"
#include "engine/output/results.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/output/text_file.hpp"
#include "engine/plain_text.hpp"
#include "engine/scene/scene_reader.hpp"
#include "engine/scene/units.hpp"
#include "engine/stop.hpp"

namespace scarp::cli {
double option_value(const std::string& option, const std::string& text, const char* bare_unit,
                    kernels::Unit unit) {
  const bool bare = text.find_first_not_of("0123456789.,+-eE") == std::string::npos;
  try {
    return parse_quantity(bare ? text + " " + bare_unit : text, unit);
  } catch (const UnitError& error) {
    throw UsageError(option + ": " + error.what());
  }
}

double positive_option(const std::string& option, const std::string& text, const char* bare_unit,
                       kernels::Unit unit) {
  const double value = option_value(option, text, bare_unit, unit);
  if (value > 0.0) return value;
  throw UsageError(fmt::format("{}: '{}' is not above 0. Try \"10 {}\".", option, text, bare_unit));
}

namespace {

SceneOverrides overrides_of(const SceneArguments& arguments) {
  SceneOverrides overrides{arguments.preset, {}};
  if (!arguments.spacing.empty()) {
    overrides.spacing = positive_option("--spacing", arguments.spacing, "m", kernels::Unit::length);
  }
  return overrides;
}

}  // namespace

Scene load_scene(const SceneArguments& arguments) {
  require_target("--json", arguments.json, arguments.file);
  Scene scene = read_scene(arguments.file, overrides_of(arguments));
  stop_if_asked(arguments.options.stop);
  return scene;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

void require_target(const std::string& option, const std::string& target,
                    const std::string& scene_file) {
  namespace fs = std::filesystem;
  if (target.empty() || target == "-") return;
  std::error_code error;
  const auto refuse = [&](const char* why) {
    throw UsageError(fmt::format("{}: '{}' {}. Try another file.", option, target, why));
  };
  if (fs::equivalent(target, scene_file, error)) refuse("is the scene itself");
  if (fs::is_directory(target, error)) refuse("is a folder");
  const fs::path folder = fs::path(target).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, error))
    refuse("lies in a folder that is not there");
}

void write_text(const std::string& target, const std::string& text) {
  if (target == "-") {
    fmt::print("{}", text);
  } else {
    write_to_target(target, text);
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
  for (const std::string& warning : check::start_warnings(simulation))
    fmt::print(stderr, "warning: {}\n", warning);
  if (!arguments.quiet) {
    fmt::print(stderr, "{}: {} soil and {} wall particles, {}, {} threads, output in {}\n",
               plain_text(scene.title.empty() ? arguments.scene.file : scene.title),
               simulation.soil_count(), simulation.wall_count(), simulation.isa(),
               simulation.threads(), plain_text(folder.string()));
  }
  const FolderLock lock(folder);
  claim_folder(folder, Command::run, scene, arguments.overwrite);
  begin_run(folder, {program_version(), scene.file, scene.text, overrides_of(arguments.scene),
                     simulation.isa(), arguments.scene.options.threads});
  return saying_how_to_go_on(folder, [&] {
    RunWriter writer(simulation, folder);
    return drive(simulation, writer, Recovery(simulation, writer),
                 {arguments.scene.json, arguments.quiet});
  });
}

}  // namespace scarp::cli
