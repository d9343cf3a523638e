// SPDX-License-Identifier: BSD-3-Clause
/// The soil that a run begins with.
#pragma once

#include <vector>

#include "engine/particles/particles.hpp"
#include "engine/particles/soil_above.hpp"
#include "engine/state.hpp"

namespace scarp {

struct InitialSoil {
  Particles particles;           ///< complete but for stress and density
  std::vector<SoilAbove> above;  ///< of each; none without a geostatic start
};

/// The soil of the scene's bodies, on their lattice, or `given`. Errors: SceneError if soil lies
/// inside a wall, or as for `generate_soil` and `completed`.
InitialSoil drawn_soil(const State& state, const Particles* given);
/// Packs it anew beside walls that the lattice does not meet, if the scene says so;
/// `State::packing` tells how much. Pre: the state has its walls' surface and dummies.
void pack_at_walls(State& state, InitialSoil& soil);

}  // namespace scarp
