// SPDX-License-Identifier: BSD-3-Clause
/// The subcommands of `scarp`; each returns the exit code and throws the library's errors.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/cli/ending.hpp"
#include "engine/simulation.hpp"
#include "kernels/constitutive/parameter_spec.hpp"

namespace scarp::cli {

/// What all commands that take a scene have in common: the scene and what to change in it.
struct SceneArguments {
  std::string file;
  std::string preset;   ///< in place of the scene's
  std::string spacing;  ///< "0.5 m" or a bare number in metres
  std::string json;     ///< where to write the numbers, "-" for standard output
  RunOptions options;
};

struct CheckArguments {
  SceneArguments scene;
  bool costs = false;     ///< time the scene without each of the parts it uses
  bool probe = false;     ///< find out what sets the time step and how far it is from unstable
  double patience = 1.0;  ///< seconds of trial steps; a rehearsal takes three to six times as long
};

struct RunArguments {
  SceneArguments scene;
  std::string folder;  ///< empty: out/<stem of the scene file>
  bool overwrite = false;
  bool quiet = false;
};

struct ResumeArguments {
  std::string folder;  ///< of `scarp run`
  std::string scene;   ///< the run's scene with more stages; empty: as it was
  bool accept_tables = false;
  std::string json;
  RunOptions options;  ///< what is not given is that of the run
  bool quiet = false;
};

struct ConvergeArguments {
  SceneArguments scene;               ///< its spacing is not used
  std::vector<std::string> spacings;  ///< three; empty: 4, 2 and 1 times the scene's
  std::string folder;                 ///< empty: out/<stem of the scene file>_converge
  bool overwrite = false;
  bool quiet = false;
};

struct FosArguments {
  SceneArguments scene;
  std::string height;  ///< of the slope; empty: that of the ground
  std::string ramp;    ///< time that the cut takes; empty: 1.4 free falls over the height
  std::string window;  ///< time after the cut in which a slope must fail; empty: five free falls
  std::string probe;   ///< empty: the scene's first
  double tolerance = 0.01;  ///< width of the bracket over its middle
  double from = 1.0;
  std::optional<double> to;
  std::string folder;  ///< empty: out/<stem of the scene file>_fos
  bool overwrite = false;
  bool quiet = false;
};

struct ElementArguments {
  SceneArguments scene;
  std::string path, material;  ///< empty material: the only one
  std::string confining = "100 kPa";
  double strain = 0.05;
  int steps = 1000;
  std::string table;  ///< empty: out/<stem of the scene file>/element_<path>.csv
};

struct NewArguments {
  std::string name;  ///< of a template; empty: list them
  std::string file;  ///< empty: NAME.toml; "-": standard output
};

struct ReportArguments {
  std::string folder;             ///< of a run, `fos` or `converge`
  double picture_megabytes = 40;  ///< that the moving picture may take; 0: none
  bool quiet = false;             ///< no progress
  bool silent = false;            ///< the page's path is not printed
};

struct WatchArguments {
  std::string folder;  ///< of a run
  int port = 0;        ///< 0: a free one
};

/// The scene of the file with the overrides applied. Errors: FileError, SceneError, UsageError.
Scene load_scene(const SceneArguments& arguments);

/// A quantity such as "100 kPa" in SI, or a bare number in `bare_unit`. Errors: UsageError.
double option_value(const std::string& option, const std::string& text, const char* bare_unit,
                    kernels::Unit unit);

/// The same, above 0. Errors: UsageError.
double positive_option(const std::string& option, const std::string& text, const char* bare_unit,
                       kernels::Unit unit);

/// All bytes of a file; empty if it cannot be read.
std::string read_text(const std::filesystem::path& path);

/// Looks before hours of work whether an option's file can be written at all, and is not the scene.
/// Errors: UsageError.
void require_target(const std::string& option, const std::string& target,
                    const std::string& scene_file);

/// Writes to a file, or to standard output for "-". Errors: FileError.
void write_text(const std::string& target, const std::string& text);

int run_command(const RunArguments& arguments);
int resume_command(const ResumeArguments& arguments);
int check_command(const CheckArguments& check);
int converge_command(const ConvergeArguments& arguments);
int fos_command(const FosArguments& arguments);
int element_command(const ElementArguments& arguments);
int new_command(const NewArguments& arguments);

/// `key`: "cohesion", "material.cohesion", "material[0].cohesion" or a section; empty: all of them.
int explain_command(const std::string& key);

int report_command(const ReportArguments& arguments);
int watch_command(const WatchArguments& arguments);

}  // namespace scarp::cli
