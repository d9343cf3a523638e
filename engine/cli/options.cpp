// SPDX-License-Identifier: BSD-3-Clause
/// Options that several commands have.
#include "engine/cli/options.hpp"

#include <string>

#include "engine/isa_names.hpp"
#include "engine/team.hpp"

namespace scarp::cli {

void add_isa_option(CLI::App& command, scarp::RunOptions& options) {
  command
      .add_option("--isa", options.isa,
                  "Use this instruction set; default: the best of the machine")
      ->check(CLI::IsMember(scarp::isa_names()));
}

void add_threads_option(CLI::App& command, scarp::RunOptions& options) {
  command
      .add_option("--threads", options.threads,
                  "Use exactly this many threads; default: as many as make it faster")
      ->check([](const std::string& text) {
        int threads = 0;
        return CLI::detail::lexical_cast(text, threads) ? scarp::complaint_about_threads(threads)
                                                        : std::string();
      });
}

void add_json_option(CLI::App& command, std::string& json) {
  command.add_option("--json", json, "Write the numbers to this file, - for standard output");
}

void add_quiet_option(CLI::App& command, bool& quiet) {
  command.add_flag("-q,--quiet", quiet, "Show no progress");
}

/// What every command with a scene takes.
void add_common_options(CLI::App& command, SceneArguments& arguments) {
  command.add_option("scene", arguments.file, "The scene, a TOML file")->required();
  add_isa_option(command, arguments.options);
  command.add_option("--preset", arguments.preset, "Replace the scene's preset")
      ->check(CLI::IsMember({"modern", "paper"}));
  add_json_option(command, arguments.json);
}

void add_scene_options(CLI::App& command, SceneArguments& arguments) {
  add_common_options(command, arguments);
  add_threads_option(command, arguments.options);
}

void add_spacing_option(CLI::App& command, SceneArguments& arguments) {
  command.add_option("--spacing", arguments.spacing,
                     "Replace the scene's particle spacing, e.g. \"0.5 m\"");
}

/// An empty value would pass for an option that was not given.
void refuse_empty_values(CLI::App& app) {
  const CLI::Validator not_empty(
      [](const std::string& value) { return value.empty() ? "it is empty" : ""; }, "");
  for (CLI::App* command : app.get_subcommands({})) {
    for (CLI::Option* option : command->get_options()) {
      if (option->get_items_expected_max() > 0) option->check(not_empty);
    }
  }
}

CLI::App* add_run_command(CLI::App& app, RunArguments& run) {
  CLI::App* command =
      app.add_subcommand("run", "Run a scene and write frames, tables and results.json");
  add_scene_options(*command, run.scene);
  add_spacing_option(*command, run.scene);
  add_folder_options(*command, run, "");
  return command;
}

CLI::App* add_resume_command(CLI::App& app, ResumeArguments& resume) {
  CLI::App* command = app.add_subcommand("resume",
                                         "Go on with a run that was stopped or killed, from its "
                                         "last checkpoint, or run it through more stages");
  command->add_option("folder", resume.folder, "Output folder of the run")
      ->required()
      ->check(CLI::ExistingDirectory);
  command->add_option("--scene", resume.scene,
                      "Scene of the run with more stages after its last; go on through them");
  command->add_flag(
      "--accept-tables", resume.accept_tables,
      "Go on after the rows that are there, even if some were changed or are missing");
  add_isa_option(*command, resume.options);
  add_threads_option(*command, resume.options);
  add_json_option(*command, resume.json);
  add_quiet_option(*command, resume.quiet);
  return command;
}

}  // namespace scarp::cli
