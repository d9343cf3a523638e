// SPDX-License-Identifier: BSD-3-Clause
/// How much longer the time step could be before a run becomes unstable, found by trying.
#pragma once

#include "engine/simulation.hpp"

namespace scarp {

struct MarginOptions {
  int steps = 300;          ///< of each trial
  double most = 4.0;        ///< longest step tried, over that of the scene
  double least = 1.0 / 16;  ///< shortest
  double tolerance = 0.05;  ///< width of the bracket over its lower end
};

/// Steps as multiples of what the scene's own CFL number gives.
struct StabilityMargin {
  double stable = 0.0;    ///< the longest that stayed stable; 0: not even `least`
  double unstable = 0.0;  ///< the shortest that did not; 0: none up to `most`
};

/// Bisects the factor on the time step with copies of `start`, each shaken by 1e-6 of the sound
/// speed. A trial is unstable when the watch stops it, or when it ends ten times as fast as the
/// shake and as one with half the scene's step: yield bounds what elasticity would let grow.
/// Limits: holds for the present state and so many steps; soil that falls or flows may gain speed
/// for other reasons, by the factor on the step at most.
StabilityMargin stability_margin(const Simulation& start, const MarginOptions& options = {});

/// Speed of sound of the stiffest material of a scene, undisturbed [m/s].
double sound_speed(const Scene& scene);

}  // namespace scarp
