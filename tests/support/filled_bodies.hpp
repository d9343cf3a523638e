// SPDX-License-Identifier: BSD-3-Clause
/// Bodies of clay filled with particles, without walls.
#pragma once

#include <utility>
#include <vector>

#include "engine/particles/generate.hpp"

namespace scarp::test {

inline Scene scene_of(int dimension, double spacing, std::vector<Body> bodies) {
  Scene scene;
  scene.dimension = dimension;
  scene.spacing = spacing;
  scene.gravity = dimension == 2 ? Vec3{0.0, -9.81, 0.0} : Vec3{0.0, 0.0, -9.81};
  scene.materials = {{.name = "clay"}, {.name = "rock"}};
  scene.bodies = std::move(bodies);
  for (Body& body : scene.bodies) {
    if (body.material.empty()) body.material = "clay";
  }
  return scene;
}

inline Particles fill(int dimension, double spacing, std::vector<Body> bodies) {
  return generate_soil(scene_of(dimension, spacing, std::move(bodies)));
}

}  // namespace scarp::test
