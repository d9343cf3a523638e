// SPDX-License-Identifier: BSD-3-Clause
/// Smoothing functions under which soil at rest begins to move by itself.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// Adds a sentence where the lattice under the weight of the soil is so unstable (`growth_rate`)
/// that a motion grows a thousandfold in the stages without damping. Pre: the scene is valid.
void check_lattice(const Scene& scene, std::vector<std::string>& found);

}  // namespace scarp
