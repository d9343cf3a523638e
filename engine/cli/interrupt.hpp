// SPDX-License-Identifier: BSD-3-Clause
/// A signal that asks for an end gets one in good order.
#pragma once

namespace scarp::cli {

/// From here on SIGINT, SIGTERM, SIGHUP and SIGXCPU ask to stop: `stop_requested` says so, and
/// `RunOptions::stop` is where it is looked at. A second SIGINT or SIGTERM, a second later or more,
/// kills as usual (closer ones are often the same wish: `timeout` and shells send theirs twice). A
/// SIGHUP that is ignored stays so (nohup). A pipe without reader and a file at its limit become
/// errors of the write. SIGQUIT is left alone.
void catch_interrupts();

bool stop_requested();

/// While it lives, the process with this id is told too.
class ToldToStop {
 public:
  explicit ToldToStop(int process);
  ToldToStop(const ToldToStop&) = delete;
  ToldToStop& operator=(const ToldToStop&) = delete;
  ~ToldToStop();
};

}  // namespace scarp::cli
