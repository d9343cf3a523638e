// SPDX-License-Identifier: BSD-3-Clause
/// What a few real steps tell about a whole run.
#pragma once

#include <cstddef>
#include <string>

#include "engine/simulation.hpp"

namespace scarp::check {

struct Trial {
  double time_step = 0.0;         ///< [s]
  double simulated = 0.0;         ///< when the trial ended [s]
  double seconds_per_step = 0.0;  ///< NaN: not measured
  std::size_t memory = 0;         ///< [bytes]
  double particles = 0.0;
  std::string failure;
};

/// Steps for about `enough` seconds after a start that is not timed: the first steps build lists,
/// warm caches and let the time step grow; then rebuilds of the lists are in their share. A run
/// that fails in them is reported, not thrown.
Trial try_steps(Simulation& simulation, double enough);

}  // namespace scarp::check
