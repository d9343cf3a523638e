// SPDX-License-Identifier: BSD-3-Clause
/// What is allowed in a scene but is probably not meant.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// One sentence per finding, for `scarp check` and the start of a run. Pre: the scene is valid.
std::vector<std::string> warnings(const Scene& scene);

}  // namespace scarp
