// SPDX-License-Identifier: BSD-3-Clause
/// Any bytes as a scene: `scarp check` takes them to the end or answers with one message of the
/// promised form.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>

#include "tests/mutants/whole_check.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path folder = [] {
    auto own = std::filesystem::temp_directory_path() / ("scarp_fuzz_" + std::to_string(getpid()));
    std::filesystem::create_directories(own);
    return own;
  }();
  constexpr double most_particles = 1000;  // a scene stays far below a second
  const scarp::CheckedText checked = scarp::check_whole(
      std::string_view(reinterpret_cast<const char*>(data), size), folder, most_particles);
  if (!checked.fault.empty()) {
    std::fprintf(stderr, "%s: %s\n", checked.fault.c_str(), checked.message.c_str());
    std::abort();
  }
  return 0;
}
