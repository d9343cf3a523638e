// SPDX-License-Identifier: BSD-3-Clause
/// Starts the report scripts.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scarp::cli {

/// The interpreter whose packages the set-up installs.
inline constexpr const char* python = "/usr/bin/python3";

/// Runs a script and waits for it; `silent` sends its standard output to the null device. A signal
/// that asks to stop reaches it too. Returns its exit code. Errors: FileError if it cannot be
/// started or was killed; Stopped.
int run_python(const std::filesystem::path& script, const std::vector<std::string>& arguments,
               bool silent);

}  // namespace scarp::cli
