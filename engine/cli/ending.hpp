// SPDX-License-Identifier: BSD-3-Clause
/// How both programs end: exit codes, and whatever is thrown becomes one of them.
#pragma once

#include <functional>
#include <stdexcept>

namespace scarp::cli {

/// `lost_soil`: the run reached its end, but soil fell out of it.
enum ExitCode { ok = 0, failed = 1, usage = 2, unstable = 3, lost_soil = 4, interrupted = 130 };

/// An option's value that cannot be used; the message begins with the option.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// All of `main`: takes the standard streams and the signals, calls `work`, says what it threw
/// under the program's name and returns the exit code; standard output that was not taken counts as
/// an error.
int end_with_exit_code(const char* program, const std::function<int()>& work);

}  // namespace scarp::cli
