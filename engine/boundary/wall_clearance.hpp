// SPDX-License-Identifier: BSD-3-Clause
/// Finds soil that starts inside a wall.
#pragma once

#include <functional>

#include "engine/particles/generate.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// No soil particle may start where a wall has its dummy particles: behind a facet, inside its
/// footprint and within the thickness of the layers, unless another face of a thin wall lies
/// between; and a rough face before soil must have room for dummies. Errors: SceneError naming the
/// wall and the particle.
void check_wall_clearance(const Scene& scene, const Particles& soil,
                          const std::function<bool()>& stop = {});

}  // namespace scarp
