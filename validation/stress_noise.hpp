// SPDX-License-Identifier: BSD-3-Clause
/// How much the stresses of neighbours differ beyond what smooth fields would.
#pragma once

#include "engine/simulation.hpp"

namespace scarp::validation {

/// Rms distances of the pressure and of the shear stress (xy; in 3D the root of the squares of xy,
/// yz and zx) of each soil particle from the linear fits through its neighbours within 2h, both
/// over the rms pressure [-].
struct StressNoise {
  double pressure = 0.0, shear = 0.0;
};

/// Of particles with three quarters of the neighbours that the lattice has inside, so that surfaces
/// do not count. NaN if there are none.
StressNoise stress_noise(const Simulation& simulation);

}  // namespace scarp::validation
