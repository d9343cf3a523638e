// SPDX-License-Identifier: BSD-3-Clause
/// Starts the report script.

#include "validation/report.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <array>
#include <system_error>

#include "validation/case_run.hpp"

extern char** environ;

namespace scarp::validation {
namespace {

// The one whose packages the set-up installs.
constexpr const char* interpreter = "/usr/bin/python3";

}  // namespace

std::string write_report(const std::filesystem::path& folder) {
  std::string program = interpreter, file = (data_folder() / "report.py").string();
  std::string argument = folder.string();
  const std::string missing = "no report: ";
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return missing + "'" + file + "' is not there.";
  if (!std::filesystem::exists(interpreter, error)) {
    return missing + fmt::format(
                         "{} is not there. The report needs Debian's python3, "
                         "python3-matplotlib and python3-h5py.",
                         interpreter);
  }
  std::array<char*, 4> arguments{program.data(), file.data(), argument.data(), nullptr};
  pid_t child = 0;
  const int problem = posix_spawn(&child, interpreter, nullptr, nullptr, arguments.data(), environ);
  if (problem != 0)
    return missing + fmt::format("{}: {}.", interpreter, std::generic_category().message(problem));
  int status = 0;
  if (waitpid(child, &status, 0) < 0 || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    return missing + fmt::format(
                         "'{} {} {}' failed; what it said stands above. It needs Debian's "
                         "python3-matplotlib and python3-h5py.",
                         program, file, argument);
  }
  return fmt::format("report: {}", (folder / "report.html").string());
}

}  // namespace scarp::validation
