// SPDX-License-Identifier: BSD-3-Clause
/// Soil packed anew beside walls that the lattice does not meet.
#pragma once

#include <cstddef>
#include <functional>

#include "engine/boundary/dummies.hpp"
#include "engine/boundary/wall_surface.hpp"
#include "engine/particles/particles.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

struct RelaxedPacking {
  std::size_t moved = 0;  ///< particles within reach of such a wall
  double residual = 0.0;  ///< rms of |sum V grad W| over them, times the spacing [-]
};

/// Moves the soil near such walls until the sum of V grad W over the neighbours of each (soil,
/// dummies, images) is zero. Beside a wall askew to the lattice it is 0.1 to 0.35 over dx, and with
/// it a uniform pressure pushes particles to and fro. The sum is the gradient of E = 1/2 sum_ij V_i
/// V_j W_ij, so that going down E ends where it is zero. Each particle keeps its mass, material and
/// id. Equation: B7. Limits: what ends in a poor minimum of E keeps a residual; corners of other
/// than right angles keep theirs.
RelaxedPacking relax_packing(const Scene& scene, const WallSurface& surface,
                             const WallDummies& dummies, int threads,
                             const std::function<bool()>& stop, Particles& soil);

}  // namespace scarp
