// SPDX-License-Identifier: BSD-3-Clause
/// How much the pressure of neighbours differs beyond what a smooth field would.
#pragma once

#include "engine/simulation.hpp"

namespace scarp::validation {

/// Rms distance of the pressure of each soil particle from the linear fit through its neighbours
/// within 2h, over the rms pressure; only particles with three quarters of the neighbours that the
/// lattice has inside, so that surfaces do not count. NaN if there are none. Limits: 2D.
double pressure_noise(const Simulation& simulation);

}  // namespace scarp::validation
