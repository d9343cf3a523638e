// SPDX-License-Identifier: BSD-3-Clause
/// What the particles of a scene show before the first step.
#pragma once

#include <string>
#include <vector>

#include "engine/simulation.hpp"

namespace scarp::check {

/// A sentence for each initial stress that the soil cannot bear, and for each place where soil has
/// nothing below it. Pre: no step has been taken.
std::vector<std::string> start_warnings(const Simulation& simulation);

}  // namespace scarp::check
