// SPDX-License-Identifier: BSD-3-Clause
/// `scarp report`: hands a run's folder to the report script.

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include "engine/cli/commands.hpp"
#include "engine/errors.hpp"

extern char** environ;

namespace scarp::cli {
namespace {

constexpr const char* interpreter =
    "/usr/bin/python3";  // the one whose packages the set-up installs

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
  std::string program = interpreter, file = script.string(), argument = folder;
  std::array<char*, 4> arguments{program.data(), file.data(), argument.data(), nullptr};
  pid_t child = 0;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  if (silent) {
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  }
  const int problem =
      posix_spawn(&child, interpreter, &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (problem != 0) {
    throw FileError(
        fmt::format("'{}': cannot be started: {}. The report needs Debian's python3, "
                    "python3-matplotlib and python3-h5py.",
                    interpreter, std::generic_category().message(problem)));
  }
  int status = 0;
  if (waitpid(child, &status, 0) < 0 || !WIFEXITED(status)) return failed;
  return WEXITSTATUS(status) == 0 ? ok : failed;
}

}  // namespace scarp::cli
