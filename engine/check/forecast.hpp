// SPDX-License-Identifier: BSD-3-Clause
/// How long a run will take, before it is started.
#pragma once

#include "engine/check/trial.hpp"
#include "engine/scene/scene.hpp"

namespace scarp::check {

/// The longest that a scene may take [s]; NaN if one of its stages has no limit.
double longest_duration(const Scene& scene);

struct Forecast {
  // NaN: a stage has no limit and did not come to rest in the rehearsal, or nothing was measured.
  double simulated = 0.0;  ///< when the run ends [s]
  double steps = 0.0;
  double wall_s = 0.0;
  double rehearsal_spacing = 0.0;   ///< 0: none; the start then stands for the whole run
  double rehearsal_complete = 1.0;  ///< share of the rehearsal that there was time for, or NaN
};

/// From `trial`, the start of the run, and a rehearsal: the whole scene on a lattice so coarse that
/// it takes about three seconds, six at most. The rehearsal tells when stages come to rest, and how
/// the time step and the cost of a step change from the start (soil in motion takes shorter steps
/// and new lists). Where a stage does not come to rest in it, one at 1.1 times the spacing
/// takes its place if more stages do. A scene that cannot be coarsened or comes apart when it is
/// goes without. `patience`: multiplies these seconds.
Forecast forecast(const Scene& scene, const RunOptions& options, const Trial& trial,
                  double patience = 1.0);

}  // namespace scarp::check
