// SPDX-License-Identifier: BSD-3-Clause
/// What a run uses of the program and what it leaves out.
#pragma once

#include <string>
#include <vector>

namespace scarp {

struct State;

/// One way the run was specialised, for `scarp check`.
struct UsedFeature {
  std::string name;
  bool used = false;
  std::string note;  ///< why, or what leaving it out saves
};

std::vector<UsedFeature> used_features(const State& state);

}  // namespace scarp
