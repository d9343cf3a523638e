// SPDX-License-Identifier: BSD-3-Clause
/// Which dummies are near a free edge of their wall.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/boundary/wall_surface.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// Dummies that may have to do with an edge.
struct EdgeDummies {
  std::vector<const Facet*> rim;  ///< by dummy: the facet whose rim it is above, if any
  std::vector<std::size_t> near;  ///< those that a place beside one on a rim may meet
};

/// By dummy, whether its wall ends within reach of the soil over it: the next place along the face
/// holds no dummy of any wall and is not behind a free-slip face either. As many places as there
/// are layers are within reach of the soil there. Dummies beyond an edge close a corner.
std::vector<bool> near_edges(const Scene& scene, const WallSurface& surface,
                             const std::vector<Vec3>& position, const EdgeDummies& dummies);

}  // namespace scarp
