// SPDX-License-Identifier: BSD-3-Clause
/// Standard streams over functions of our own.

#include "engine/cli/streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <iostream>
#include <new>
#include <streambuf>
#include <system_error>

namespace scarp::cli {
namespace {

int output_error = 0;  ///< errno of the first write that standard output did not take

/// All of it, or the reason why not.
int write_all(int descriptor, const char* text, std::size_t size) {
  while (size > 0) {
    const ssize_t written = ::write(descriptor, text, size);
    if (written < 0 && errno != EINTR) return errno;
    if (written > 0) {
      text += written;
      size -= static_cast<std::size_t>(written);
    }
  }
  return 0;
}

// A short count would set the stream's error, on which its users throw.
ssize_t write_output(void*, const char* text, std::size_t size) {
  const int error = write_all(STDOUT_FILENO, text, size);
  if (output_error == 0) output_error = error;
  return static_cast<ssize_t>(size);
}
ssize_t write_error(void*, const char* text, std::size_t size) {
  write_all(STDERR_FILENO, text, size);
  return static_cast<ssize_t>(size);
}

/// Brings what goes to std::cout (the option parser's help) the same way.
class ToOutput : public std::streambuf {
  int_type overflow(int_type c) override { return std::fputc(c, stdout); }
  std::streamsize xsputn(const char* text, std::streamsize size) override {
    return static_cast<std::streamsize>(
        std::fwrite(text, 1, static_cast<std::size_t>(size), stdout));
  }
};

void open_closed_descriptors() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF)
      ::open("/dev/null", O_RDWR);  // takes the lowest free number, which is this one
  }
}

}  // namespace

void take_standard_streams() {
  open_closed_descriptors();
  // glibc lets a program put streams of its own in place of these.
  if (FILE* output = ::fopencookie(nullptr, "w", {nullptr, write_output, nullptr, nullptr})) {
    std::setvbuf(output, nullptr, isatty(STDOUT_FILENO) != 0 ? _IOLBF : _IOFBF, BUFSIZ);
    stdout = output;
    // Never destroyed, since std::cout is flushed after all destructors; and nothing before the
    // commands may need memory that could be refused.
    alignas(ToOutput) static std::byte place[sizeof(ToOutput)];
    std::cout.rdbuf(::new (place) ToOutput);
  }
  if (FILE* error = ::fopencookie(nullptr, "w", {nullptr, write_error, nullptr, nullptr})) {
    std::setvbuf(error, nullptr, _IONBF, 0);
    stderr = error;
  }
}

std::string output_problem() {
  std::fflush(stdout);
  return output_error == 0 ? "" : std::generic_category().message(output_error);
}

}  // namespace scarp::cli
