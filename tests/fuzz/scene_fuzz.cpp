// SPDX-License-Identifier: BSD-3-Clause
/// Any bytes as a scene: the reader takes them or answers with one message of the promised form.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "engine/errors.hpp"
#include "engine/scene/scene_reader.hpp"
#include "engine/scene/warnings.hpp"
#include "tests/support/scene_message.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    scarp::warnings(scarp::read_scene_text(text, "bytes"));
  } catch (const scarp::SceneError& error) {  // anything else ends the process: that is a finding
    const std::string fault = scarp::fault_of_message(error.what(), "bytes");
    if (!fault.empty()) {
      std::fprintf(stderr, "a message that is wrong (%s): %s\n", fault.c_str(), error.what());
      std::abort();
    }
  }
  return 0;
}
