// SPDX-License-Identifier: BSD-3-Clause
/// Whether a scene's soil can bear the stress it starts with.
#pragma once

#include <string>
#include <vector>

#include "engine/simulation.hpp"

namespace scarp {

/// From active to passive.
struct RestRange {
  double active = 0.0;   ///< below it the soil spreads [-]
  double passive = 0.0;  ///< above it the soil heaves; infinite where the surface is that wide [-]
};

/// Bounds of K inside the yield surface under the pressure p along gravity and K p across, in both
/// directions alike. Strength is divided by `reduction`. Pre: the model has a yield function,
/// `pressure` is above 0 and isotropic pressure does not yield.
RestRange rest_range(const Material& material, double reduction, double pressure);

/// Findings about a start outside the yield surface of the first stage's strength: of geostatic
/// stress for each such material the bounds on K0 at its greatest pressure and what K0 becomes; of
/// uniform stress how much of it the surface bears. Pre: no step has been taken.
std::vector<std::string> initial_stress_warnings(const Simulation& simulation);

}  // namespace scarp
