// SPDX-License-Identifier: BSD-3-Clause
/// A child process that ends with its parent.

#include "engine/cli/python.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "engine/cli/interrupt.hpp"
#include "engine/errors.hpp"
#include "engine/stop.hpp"

extern char** environ;

namespace scarp::cli {
namespace {

/// Of a new process: signals act on it as on any other.
class Start {
 public:
  explicit Start(bool silent) {
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_init(&files_);
    sigset_t usual;
    sigemptyset(&usual);
    for (const int signal : {SIGPIPE, SIGXFSZ}) sigaddset(&usual, signal);
    posix_spawnattr_setsigdefault(&attributes_, &usual);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETSIGDEF);
    if (silent) posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  }
  Start(const Start&) = delete;
  Start& operator=(const Start&) = delete;
  ~Start() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }

  pid_t operator()(char* const* arguments) const {
    pid_t child = 0;
    const int problem = posix_spawn(&child, python, &files_, &attributes_, arguments, environ);
    if (problem == 0) return child;
    throw FileError(
        fmt::format("'{}': cannot be started: {}. The report needs Debian's python3, "
                    "python3-matplotlib and python3-h5py.",
                    python, std::generic_category().message(problem)));
  }

 private:
  posix_spawnattr_t attributes_{};
  posix_spawn_file_actions_t files_{};
};

}  // namespace

int run_python(const std::filesystem::path& script, const std::vector<std::string>& arguments,
               bool silent) {
  std::fflush(stdout);  // what has been said comes before what the script says
  const std::string file = script.string();
  std::vector<std::string> words{python, file};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t child = Start(silent)(pointers.data());
  int status = 0;
  {
    const ToldToStop told(child);
    while (waitpid(child, &status, 0) < 0) {
      if (errno != EINTR) throw FileError(fmt::format("'{}': was lost sight of.", file));
    }
  }
  stop_if_asked(stop_requested);
  if (WIFEXITED(status)) return WEXITSTATUS(status);
  throw FileError(fmt::format("'{}': was ended by signal {}.", file, WTERMSIG(status)));
}

}  // namespace scarp::cli
