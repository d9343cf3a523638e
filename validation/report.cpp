// SPDX-License-Identifier: BSD-3-Clause
/// Starts the report script.

#include "validation/report.hpp"

#include <fmt/format.h>

#include <system_error>

#include "engine/cli/python.hpp"
#include "engine/errors.hpp"
#include "validation/case_run.hpp"

namespace scarp::validation {
std::string write_report(const std::filesystem::path& folder, bool quiet) {
  const std::filesystem::path script = data_folder() / "report.py";
  const std::string missing = "no report: ";
  std::error_code error;
  if (!std::filesystem::exists(script, error))
    return missing + "'" + script.string() + "' is not there.";
  std::vector<std::string> words{folder.string()};
  if (quiet) words.push_back("--quiet");
  try {
    if (cli::run_python(script, words, false) == 0)
      return fmt::format("report: {}", (folder / "report.html").string());
  } catch (const FileError& problem) {
    return missing + problem.what();
  }
  return missing + fmt::format(
                       "'{} {} {}' failed; what it said stands above. It needs Debian's "
                       "python3-matplotlib and python3-h5py.",
                       cli::python, script.string(), folder.string());
}

}  // namespace scarp::validation
