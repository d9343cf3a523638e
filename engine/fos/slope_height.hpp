// SPDX-License-Identifier: BSD-3-Clause
/// The height that the failure criterion is measured with.
#pragma once

#include "engine/scene/scene.hpp"

namespace scarp {

/// From the lowest to the highest point of the ground as the scene draws it [m]: tops of the bodies
/// over a grid of half a spacing in plan. Errors: SceneError if gravity is not straight down.
double slope_height(const Scene& scene);

}  // namespace scarp
