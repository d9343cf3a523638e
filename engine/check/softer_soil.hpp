// SPDX-License-Identifier: BSD-3-Clause
/// Whether a long run would be shorter with softer soil.
#pragma once

#include <optional>
#include <string>

#include "engine/scene/scene.hpp"

namespace scarp::check {

/// A sentence, if the run takes more than ten minutes, all of its soil yields, and a quarter of the
/// stiffness would still be so stiff that the weight strains it by no more than 0.2 %: run-outs
/// then hardly change if the viscosity stays the same (THEORY.md section 3). `wall_s`: what the
/// run is expected to take [s]; NaN says nothing. Pre: the scene is valid.
std::optional<std::string> softer_soil_note(const Scene& scene, double wall_s);

}  // namespace scarp::check
