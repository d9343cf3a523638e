// SPDX-License-Identifier: BSD-3-Clause
/// The force on a wall.
#pragma once

#include <string>

#include "engine/scene/scene.hpp"

namespace scarp {

/// Sum of the forces the soil exerts on a wall [N, per metre in 2D]: those of all pairs where the
/// particles stand now, and the mean over the last step of what no-slip faces held off (B4).
struct WallReaction {
  std::string wall;
  Vec3 force{};
};

}  // namespace scarp
