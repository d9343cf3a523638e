// SPDX-License-Identifier: BSD-3-Clause
/// A scene that can be looked at within seconds.
#include "engine/check/subject.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/errors.hpp"
#include "engine/particles/generate.hpp"
#include "engine/particles/particle_limit.hpp"

namespace scarp::check {
namespace {

constexpr double most_looked_at = 3e5;  // particles that can be made and moved within seconds

}  // namespace

Scene thinned(Scene scene, double particles, double most) {
  scene.spacing *= std::pow(std::max(1.0, particles / most), 1.0 / scene.dimension);
  return scene;
}

Subject subject_of(const Scene& scene, const RunOptions& options) {
  validate(scene);
  std::vector<double> about = estimate_particles(scene);
  const double total = std::accumulate(about.begin(), about.end(), 0.0);
  if (total > most_looked_at && total < most_particles(scene)) {
    try {
      return {Simulation(thinned(scene, total, most_looked_at), options), about, total, true};
    } catch (const SceneError&) {  // too coarse for its shapes: then the scene itself has to do
    }
  }
  Simulation simulation(scene, options);
  std::vector<double> particles(scene.materials.size(), 0.0);
  for (const double m : simulation.field("material")) ++particles.at(static_cast<std::size_t>(m));
  const auto count = static_cast<double>(simulation.soil_count());
  return {std::move(simulation), std::move(particles), count, false};
}

Trial scaled(Trial trial, const Subject& subject, double spacing) {
  const double share = subject.share();
  trial.time_step *= spacing / subject.simulation.scene().spacing;
  trial.seconds_per_step *= share;
  trial.memory = static_cast<std::size_t>(static_cast<double>(trial.memory) * share);
  trial.particles = subject.total;
  return trial;
}

}  // namespace scarp::check
