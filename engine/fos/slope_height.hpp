// SPDX-License-Identifier: BSD-3-Clause
/// The height that the failure criterion is measured with.
#pragma once

#include "engine/scene/scene.hpp"

namespace scarp {

/// From the lowest to the highest point of the ground along gravity [m]. Gravity straight down:
/// tops of the bodies as drawn over a grid of half a spacing in plan. Any other direction: the free
/// surface above the uppermost particles, less exact by up to a spacing.
double slope_height(const Scene& scene);

}  // namespace scarp
