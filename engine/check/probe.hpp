// SPDX-License-Identifier: BSD-3-Clause
/// `scarp check --probe`: what sets the time step of a scene, and how far it is from unstable.
#pragma once

#include <nlohmann/json.hpp>

#include "engine/simulation.hpp"

namespace scarp::check {

/// Steps a simulation at its start a few hundred times, then tries longer steps on copies. As JSON:
/// steps, time_step, step_limits, signal_material, materials (name, sound_speed,
/// time_step), margin (stable, unstable), acoustic_cfl_limit, failure.
nlohmann::ordered_json probe(const Simulation& start);

}  // namespace scarp::check
