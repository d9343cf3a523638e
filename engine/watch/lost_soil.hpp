// SPDX-License-Identifier: BSD-3-Clause
/// Counts soil that has left everything that could hold it.
#pragma once

#include "engine/state.hpp"

namespace scarp {

/// Marks the particles that are lost now. With gravity: soil that falls, has fallen by more than
/// the reach 2h since the last reset, meets no wall that stands on its free flight from here, and
/// has no soil below it but such as falls likewise. Without: soil outside the box around all walls
/// by more than that reach, behind the wall that is nearest, on a straight way that meets none.
/// In a scene without walls nothing is lost. Once lost, a particle stays so: it goes on moving, but
/// neither rest nor the height of the soil asks for it. THEORY.md section 10.
void count_lost_soil(State& state);

}  // namespace scarp
