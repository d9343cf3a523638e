// SPDX-License-Identifier: BSD-3-Clause
/// `scarp report`: hands a run's folder to the report script.

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

}  // namespace

int report_command(const std::string& folder, bool silent) {
  const std::filesystem::path script = report_script();
  std::error_code error;
  if (!std::filesystem::exists(script, error)) {
    throw FileError(fmt::format(
        "'{}': the report script is not there. Set SCARP_REPORT to the path of scarp_report.py.",
        script.string()));
  }
  return run_python(script, folder, silent) == 0 ? ok : failed;
}

}  // namespace scarp::cli
