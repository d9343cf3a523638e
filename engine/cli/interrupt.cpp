// SPDX-License-Identifier: BSD-3-Clause
/// The flag that a signal sets.

#include "engine/cli/interrupt.hpp"

#include <csignal>

namespace scarp::cli {
namespace {

volatile std::sig_atomic_t stop = 0;

extern "C" void request_stop(int signal) {
  stop = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void catch_interrupts() {
  std::signal(SIGINT, request_stop);
  std::signal(SIGTERM, request_stop);
}

bool stop_requested() { return stop != 0; }

}  // namespace scarp::cli
