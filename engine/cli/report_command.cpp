// SPDX-License-Identifier: BSD-3-Clause
/// `scarp report` and `scarp watch`: hand a run's folder to their scripts.

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "engine/cli/commands.hpp"
#include "engine/cli/python.hpp"
#include "engine/errors.hpp"

namespace scarp::cli {
namespace {

/// SCARP_REPORT, else beside an installed program, else in the source tree it was built from.
std::filesystem::path report_script() {
  namespace fs = std::filesystem;
  if (const char* chosen = std::getenv("SCARP_REPORT"); chosen && *chosen) return chosen;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  fs::path installed = program.parent_path().parent_path() / "share/scarp/report/scarp_report.py";
  if (!error && fs::exists(installed, error)) return installed;
  return SCARP_REPORT_SCRIPT;
}

/// The scripts of the source tree have no viewer beside them; the build made it elsewhere.
void show_viewer_of_build(const std::filesystem::path& script) {
  constexpr int keep = 0;
  if (script.parent_path() == std::filesystem::path(SCARP_REPORT_SCRIPT).parent_path())
    ::setenv("SCARP_VIEWER", SCARP_VIEWER_SCRIPT, keep);
}

/// A script of the report's folder.
std::filesystem::path required_script(const char* name) {
  std::filesystem::path script = report_script().replace_filename(name);
  std::error_code error;
  if (std::filesystem::exists(script, error)) {
    show_viewer_of_build(script);
    return script;
  }
  throw FileError(
      fmt::format("'{}': the script is not there. Set SCARP_REPORT to the path of scarp_report.py.",
                  script.string()));
}

}  // namespace

int report_command(const ReportArguments& arguments) {
  std::vector<std::string> words{"--picture", fmt::format("{}", arguments.picture_megabytes)};
  if (arguments.quiet) words.push_back("--quiet");
  words.insert(words.end(), {"--", arguments.folder});
  return run_python(required_script("scarp_report.py"), words, arguments.silent) == 0 ? ok : failed;
}

int watch_command(const WatchArguments& arguments) {
  const std::vector<std::string> words{"--port", fmt::format("{}", arguments.port), "--",
                                       arguments.folder};
  try {
    return run_python(required_script("scarp_watch.py"), words, false) == 0 ? ok : failed;
  } catch (const Stopped&) {
    return ok;  // nothing else ends it
  }
}

}  // namespace scarp::cli
