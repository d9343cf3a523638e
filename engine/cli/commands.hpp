// SPDX-License-Identifier: BSD-3-Clause
/// The subcommands of `scarp`; each returns the exit code and throws the library's errors.
#pragma once

#include <string>
#include <vector>

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

struct ConvergeArguments {
  SceneArguments scene;               ///< its spacing is not used
  std::vector<std::string> spacings;  ///< three; empty: 4, 2 and 1 times the scene's
  std::string folder;                 ///< empty: out/<stem of the scene file>_converge
  bool quiet = false;
};

/// The scene of the file with the overrides applied. Errors: FileError, SceneError, UnitError.
Scene load_scene(const SceneArguments& arguments);

/// A length from the command line, "0.5 m" or a bare number in metres. Errors: UnitError.
double length_of(const std::string& text);

/// Writes to a file, or to standard output for "-". Errors: FileError.
void write_text(const std::string& target, const std::string& text);

int run_command(const RunArguments& arguments);
int check_command(const SceneArguments& arguments);
int converge_command(const ConvergeArguments& arguments);

/// `silent`: the page's path is not printed.
int report_command(const std::string& folder, bool silent = false);

}  // namespace scarp::cli
