// SPDX-License-Identifier: BSD-3-Clause
/// The subcommands of `scarp`; each returns the exit code and throws the library's errors.
#pragma once

#include <string>

#include "engine/simulation.hpp"

namespace scarp::cli {

enum ExitCode { ok = 0, failed = 1, usage = 2, unstable = 3, interrupted = 130 };

/// What `run` and `check` have in common: a scene and what to change in it.
struct SceneArguments {
  std::string file;
  std::string preset;   ///< in place of the scene's
  std::string spacing;  ///< "0.5 m" or a bare number in metres
  std::string json;     ///< where to write the numbers, "-" for standard output
  RunOptions options;
};

struct RunArguments {
  SceneArguments scene;
  std::string folder;  ///< empty: out/<stem of the scene file>
  bool quiet = false;
};

/// The scene of the file with the overrides applied. Errors: FileError, SceneError, UnitError.
Scene load_scene(const SceneArguments& arguments);

/// Writes to a file, or to standard output for "-". Errors: FileError.
void write_text(const std::string& target, const std::string& text);

int run_command(const RunArguments& arguments);
int check_command(const SceneArguments& arguments);
int report_command(const std::string& folder);

}  // namespace scarp::cli
