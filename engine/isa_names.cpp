// SPDX-License-Identifier: BSD-3-Clause
/// The instruction sets that this build and this machine have, and which of them a run takes.
#include "engine/isa_names.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "engine/setup.hpp"

namespace scarp {

std::vector<std::string> isa_names() {
  std::vector<std::string> names;
  for (const kernels::Isa isa : kernels::compiled_isas()) names.push_back(kernels::isa_name(isa));
  return names;
}

const kernels::KernelTable& choose_table(const RunOptions& options) {
  std::string wanted = options.isa;
  if (wanted.empty()) {
    if (const char* environment = std::getenv("SCARP_ISA")) wanted = environment;
  }
  const auto available = kernels::available_isas();
  if (wanted.empty()) return kernels::kernels_of(available.back());
  const auto isa = kernels::isa_named(wanted);
  if (!isa || std::find(available.begin(), available.end(), *isa) == available.end()) {
    std::string names;
    for (const kernels::Isa one : available) names += fmt::format(" {}", kernels::isa_name(one));
    throw SceneError(
        fmt::format("instruction set '{}' is not available here; try one of:{}", wanted, names));
  }
  return kernels::kernels_of(*isa);
}

}  // namespace scarp
