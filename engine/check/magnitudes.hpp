// SPDX-License-Identifier: BSD-3-Clause
/// Numbers of a scene that soils do not have: mostly a unit that was forgotten.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// Adds one sentence per finding. Pre: the scene is valid.
void check_magnitudes(const Scene& scene, std::vector<std::string>& found);

/// "20 deg" of an angle in radians.
std::string degrees_text(double angle);

}  // namespace scarp
