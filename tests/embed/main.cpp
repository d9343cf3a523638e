// SPDX-License-Identifier: BSD-3-Clause
/// An outside program: a block of clay on a no-slip base, made in code, 50 steps, positions read
/// back.
#include <cmath>
#include <cstdio>

#include "engine/simulation.hpp"

int main() {
  scarp::Scene scene;
  scene.spacing = 0.1;
  // Young's modulus, Poisson's ratio, cohesion, friction angle, dilation angle, cone
  scene.materials = {{"clay", "drucker_prager", 2000.0, {10e6, 0.3, 10e3, 0.35, 0.0, 0.0}}};
  scene.bodies = {{.shape = scarp::Polygon{{{1.0, 0.0}, {2.0, 0.0}, {2.0, 0.5}, {1.0, 0.5}}}}};
  scene.walls = {{"base", scarp::WallKind::no_slip, {{{}, {1, 0, 0}, {}, 3.0, 0.0, {0, 1, 0}}}}};
  scene.stages = {{"fall", scarp::StageEnd::duration, 10.0}};

  scarp::Simulation simulation(scene);
  for (int i = 0; i < 50; ++i) simulation.step();

  double lowest = INFINITY, sum = 0.0;
  const auto position = simulation.field("position");  // x, y, z of each particle
  for (std::size_t i = 0; i < position.size(); ++i) {
    sum += position[i];
    if (i % 3 == 1) lowest = std::fmin(lowest, position[i]);
  }
  std::printf("t = %g s, lowest particle at y = %g m\n", simulation.last_step().time, lowest);
  return std::isfinite(sum) && std::isfinite(lowest) ? 0 : 1;
}
