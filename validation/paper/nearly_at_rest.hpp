// SPDX-License-Identifier: BSD-3-Clause
/// When a slide has ended although single grains tremble on.
#pragma once

#include "engine/simulation.hpp"

namespace scarp::validation {

/// Whether 99.9 % of the soil is slower than the last stage's rest velocity, at least three times
/// sqrt(H/g) after that stage began; H is the height of the soil [m]. A stage `until = "rest"`
/// waits for the last grain. Looks at every 50th step and else says no. Limits: a failure that
/// needs longer than that to begin is taken for rest.
bool nearly_at_rest(const Simulation& now, double height);

}  // namespace scarp::validation
