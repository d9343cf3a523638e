// SPDX-License-Identifier: BSD-3-Clause
/// What a command that only looks at a scene takes its measurements on.
#pragma once

#include <vector>

#include "engine/check/trial.hpp"
#include "engine/scene/scene.hpp"
#include "engine/simulation.hpp"

namespace scarp::check {

/// The scene itself, or, where it has so many particles that they could not be looked at within
/// seconds, the same scene on a coarser lattice.
struct Subject {
  Simulation simulation;
  std::vector<double> particles;  ///< of the scene itself, by material; about, if `coarser`
  double total = 0.0;             ///< sum of them
  bool coarser = false;

  /// How many times the number of particles of `simulation`.
  double share() const { return total / static_cast<double>(simulation.soil_count()); }
};

/// Errors: SceneError as from Simulation.
Subject subject_of(const Scene& scene, const RunOptions& options);

/// The scene on a lattice of about `most` particles, from how many it has; itself if that is more.
Scene thinned(Scene scene, double particles, double most);

/// What the trial of `subject` tells about the scene itself: a step costs as the particles go, and
/// is as long as the spacing.
Trial scaled(Trial trial, const Subject& subject, double spacing);

}  // namespace scarp::check
