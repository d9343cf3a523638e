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
  double passive = 0.0;  ///< above it the soil heaves; infinite where the cone is that wide [-]
};

/// On the Drucker-Prager cone under the pressure p along gravity and K p across, in both directions
/// alike: |1 - K| p/sqrt(3) = a_phi (1 + 2 K) p + k_c. With s = sqrt(3) a_phi and t = sqrt(3) k_c/p
/// the ends are (1 - s - t)/(1 + 2 s) and (1 + s + t)/(1 - 2 s). Strength is divided by
/// `reduction`. Equation: E9. Pre: the material is Drucker-Prager, `pressure` above 0.
RestRange rest_range(const Material& material, double reduction, double pressure);

/// Findings about a start outside the yield surface of the first stage's strength: of geostatic
/// stress for each such material the bounds on K0 at its greatest pressure and what K0 becomes; of
/// uniform stress how much of it the surface bears. Pre: no step has been taken.
std::vector<std::string> initial_stress_warnings(const Simulation& simulation);

}  // namespace scarp
