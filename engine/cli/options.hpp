// SPDX-License-Identifier: BSD-3-Clause
/// Options that several commands have, and the commands that more than one program has.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "engine/cli/commands.hpp"

namespace scarp::cli {

inline constexpr const char* exit_codes_text =
    "Exit codes: 0 done, 1 error, 2 bad usage, 3 the run became unstable, 4 the run ended but "
    "lost soil, 130 stopped by a signal.";

void add_quiet_option(CLI::App& command, bool& quiet);
/// What every command with a scene takes, but for threads.
void add_common_options(CLI::App& command, SceneArguments& arguments);
void add_scene_options(CLI::App& command, SceneArguments& arguments);
void add_spacing_option(CLI::App& command, SceneArguments& arguments);

/// What every command that fills a folder ends with; `ending` tells its folder from those of
/// others.
template <class Arguments>
void add_folder_options(CLI::App& command, Arguments& arguments, const std::string& ending) {
  command.add_option("-o,--out", arguments.folder,
                     "Output folder; default: out/<name of the scene file>" + ending);
  command.add_flag("--overwrite", arguments.overwrite,
                   "Remove the results in the folder first, whatever left them there");
  add_quiet_option(command, arguments.quiet);
}

CLI::App* add_run_command(CLI::App& app, RunArguments& run);
CLI::App* add_resume_command(CLI::App& app, ResumeArguments& resume);

/// An empty value would pass for an option that was not given.
void refuse_empty_values(CLI::App& app);

}  // namespace scarp::cli
