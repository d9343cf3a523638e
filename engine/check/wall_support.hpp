// SPDX-License-Identifier: BSD-3-Clause
/// Finds soil that has nothing below it.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// A sentence for each place where no wall lies below soil, along gravity, whatever the distance:
/// at the start, once a wall is removed, and at the end of a stage in which one has moved (by its
/// velocity times the duration); `soil` is taken where it lies now. A wall carries on its
/// soil side alone. Without gravity there is none. Limits: soil over an edge is told as well,
/// though it may hang on the soil beside it.
std::vector<std::string> soil_over_nothing(const Scene& scene, const std::vector<Vec3>& soil);

}  // namespace scarp
