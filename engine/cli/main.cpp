// SPDX-License-Identifier: BSD-3-Clause
/// The program `scarp`: options to commands, errors to exit codes.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <new>

#include "engine/cli/commands.hpp"
#include "engine/errors.hpp"
#include "engine/scene/units.hpp"

namespace {

using namespace scarp::cli;

void add_scene_options(CLI::App& command, SceneArguments& arguments) {
  command.add_option("scene", arguments.file, "The scene, a TOML file")->required();
  command.add_option("--threads", arguments.options.threads, "Threads; 0 takes what OpenMP offers")
      ->check(CLI::Range(0, 4096));
  command.add_option("--isa", arguments.options.isa, "Instruction set: sse2, avx2, avx512")
      ->check(CLI::IsMember({"sse2", "avx2", "avx512"}));
  command.add_option("--preset", arguments.preset, "Replace the scene's preset: modern, paper")
      ->check(CLI::IsMember({"modern", "paper"}));
  command.add_option("--json", arguments.json, "Write the numbers here, - for standard output");
}

void add_spacing_option(CLI::App& command, SceneArguments& arguments) {
  command.add_option("--spacing", arguments.spacing,
                     "Replace the particle spacing, e.g. \"0.5 m\"");
}

int run_program(int argc, char** argv) {
  CLI::App app{"Smoothed-particle hydrodynamics for slope failure and granular collapse"};
  app.set_version_flag("--version", "scarp " SCARP_VERSION);
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 done, 1 error, 2 bad usage, 3 the run became unstable, 130 interrupted.");

  RunArguments run;
  CLI::App* run_app = app.add_subcommand("run", "Run a scene; leaves frames, tables, results.json");
  add_scene_options(*run_app, run.scene);
  add_spacing_option(*run_app, run.scene);
  run_app->add_option("-o,--out", run.folder,
                      "Output folder; default out/<name of the scene file>");
  run_app->add_flag("-q,--quiet", run.quiet, "No progress");

  SceneArguments check;
  CLI::App* check_app = app.add_subcommand(
      "check", "Say what a scene is, uses, leaves out and needs, after a few trial steps");
  add_scene_options(*check_app, check);
  add_spacing_option(*check_app, check);

  ConvergeArguments converge;
  CLI::App* converge_app = app.add_subcommand(
      "converge", "Run a scene at three spacings: estimated errors, and which spacing to use");
  add_scene_options(*converge_app, converge.scene);
  converge_app
      ->add_option(
          "--spacings", converge.spacings,
          "Three spacings, e.g. \"1 m, 0.5 m, 0.25 m\"; default 4, 2 and 1 times the scene's")
      ->delimiter(',')
      ->expected(3);
  converge_app->add_option("-o,--out", converge.folder,
                           "Output folder; default out/<name of the scene file>_converge");
  converge_app->add_flag("-q,--quiet", converge.quiet, "No progress");

  std::string report_folder;
  CLI::App* report_app = app.add_subcommand("report", "Draw the figures and report.html of a run");
  report_app->add_option("folder", report_folder, "Output folder of a run")
      ->required()
      ->check(CLI::ExistingDirectory);

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ok : usage;
  }
  if (*run_app) return run_command(run);
  if (*check_app) return check_command(check);
  if (*converge_app) return converge_command(converge);
  return report_command(report_folder);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run_program(argc, argv);
  } catch (const scarp::UnitError& error) {
    fmt::print(stderr, "scarp: --spacing: {}\n", error.what());
    return usage;
  } catch (const scarp::SimulationInstability& error) {
    fmt::print(stderr, "scarp: {}\n", error.what());
    return unstable;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "scarp: not enough memory for this scene; try a larger spacing.\n");
    return failed;
  } catch (const std::exception& error) {
    fmt::print(stderr, "scarp: {}\n", error.what());
    return failed;
  }
}
