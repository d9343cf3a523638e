// SPDX-License-Identifier: BSD-3-Clause
/// Words for instruction sets.
#pragma once

#include <string>
#include <vector>

namespace scarp {

/// Instruction sets that the library has kernels for, best last: "sse2", "avx2", "avx512", or
/// "neon" on 64-bit ARM. A machine may lack the better ones.
std::vector<std::string> isa_names();

}  // namespace scarp
