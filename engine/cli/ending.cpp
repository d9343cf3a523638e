// SPDX-License-Identifier: BSD-3-Clause
/// From exceptions to exit codes.

#include "engine/cli/ending.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>

#include "engine/cli/interrupt.hpp"
#include "engine/cli/streams.hpp"
#include "engine/errors.hpp"
#include "engine/plain_text.hpp"

namespace scarp::cli {
namespace {

/// Memory kept back for the end: what is destroyed and written when there is no more needs some,
/// and destructors that find none (those of the JSON library) end the program at once.
std::atomic<void*> reserve = nullptr;

void keep_memory_back() {
  constexpr std::size_t enough = 1 << 20;
  reserve = std::malloc(enough);
  std::set_new_handler([] {
    std::free(reserve.exchange(nullptr));
    throw std::bad_alloc();
  });
}

int exit_code_of(const char* program, const std::function<int()>& work) {
  const auto say = [program] {
    try {
      std::fprintf(stderr, "%s: %s\n", program,
                   plain_text(reason_of(std::current_exception())).c_str());
    } catch (const std::bad_alloc&) {
      std::fprintf(stderr, "%s: not enough memory.\n", program);
    }
  };
  try {
    return work();
  } catch (const Stopped&) {
    say();
    return interrupted;
  } catch (const UsageError&) {
    say();
    return usage;
  } catch (const SimulationInstability&) {
    say();
    return unstable;
  } catch (...) {
    say();
    return failed;
  }
}

}  // namespace

int end_with_exit_code(const char* program, const std::function<int()>& work) {
  keep_memory_back();
  take_standard_streams();
  catch_interrupts();
  const int code = exit_code_of(program, work);
  const std::string problem = output_problem();
  if (problem.empty()) return code;
  std::fprintf(stderr, "%s: standard output cannot be written: %s\n", program, problem.c_str());
  return code == ok ? failed : code;
}

}  // namespace scarp::cli
