// SPDX-License-Identifier: BSD-3-Clause
/// The three-dimensional counterpart of a plane-strain scene.
#pragma once

#include "engine/scene/scene.hpp"

namespace scarp::validation {

/// The scene over 0 <= z <= `depth` [m], y still up: boxes and walls extruded along z, closed by
/// smooth walls at both ends if the scene has walls, free if not. Choose at least four spacings:
/// soil thinner than the support of its images would be wrong. Errors: Error for a body that is not
/// a box.
Scene extruded(Scene plane, double depth);

}  // namespace scarp::validation
