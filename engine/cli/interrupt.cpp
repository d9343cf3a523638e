// SPDX-License-Identifier: BSD-3-Clause
/// The flag that a signal sets.

#include "engine/cli/interrupt.hpp"

#include <csignal>
#include <ctime>
#include <initializer_list>

namespace scarp::cli {
namespace {

volatile std::sig_atomic_t stop = 0;
volatile std::sig_atomic_t child = 0;
std::timespec asked{};  // of the first signal; only the handler uses it

double seconds_since(const std::timespec& then) {
  std::timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec - then.tv_sec) +
         1e-9 * static_cast<double>(now.tv_nsec - then.tv_nsec);
}

/// Nothing here that a handler may not do.
extern "C" void request_stop(int signal) {
  const int told = child;
  if (told > 0) ::kill(told, signal == SIGXCPU ? SIGTERM : signal);
  if (stop == 0) {
    ::clock_gettime(CLOCK_MONOTONIC, &asked);
    stop = 1;
    return;
  }
  constexpr double same_wish = 1.0;
  const bool insists = signal == SIGINT || signal == SIGTERM;
  if (!insists || seconds_since(asked) < same_wish) return;
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

void set_handler(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  // One at a time: `asked` is written by the first.
  for (const int other : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) ::sigaddset(&action.sa_mask, other);
  ::sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_interrupts() {
  struct sigaction before {};
  ::sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) set_handler(SIGHUP, request_stop);
  for (const int signal : {SIGINT, SIGTERM, SIGXCPU}) set_handler(signal, request_stop);
  for (const int signal : {SIGPIPE, SIGXFSZ}) set_handler(signal, SIG_IGN);
}

bool stop_requested() { return stop != 0; }

ToldToStop::ToldToStop(int process) {
  child = process;
  if (stop_requested()) ::kill(process, SIGTERM);
}

ToldToStop::~ToldToStop() { child = 0; }

}  // namespace scarp::cli
