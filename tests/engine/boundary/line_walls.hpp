// SPDX-License-Identifier: BSD-3-Clause
/// Scenes of walls alone, for tests of their layout.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "engine/boundary/dummies.hpp"
#include "engine/scene/facets.hpp"
#include "engine/scene/scene.hpp"

namespace scarp::test {

using Points2 = std::vector<std::array<double, 2>>;

/// Spacing 0.5 m and h = 1.5 dx: three layers, 1.5 m thick; without inner points.
inline Scene empty_scene(int dimension) {
  Scene scene;
  scene.dimension = dimension;
  scene.spacing = 0.5;
  scene.numerics.smoothing_ratio = 1.5;
  scene.numerics.force_correction = false;
  scene.materials = {{.name = "soil"}};
  return scene;
}

inline Wall line_wall(const std::string& name, WallKind kind, const Points2& points) {
  Wall wall;
  wall.name = name;
  wall.kind = kind;
  wall.facets = line_facets(points);
  return wall;
}

inline Scene line_scene(const Points2& points, double spacing = 0.5) {
  Scene scene = empty_scene(2);
  scene.spacing = spacing;
  scene.walls = {line_wall("wall", WallKind::no_slip, points)};
  return scene;
}

/// The cells of the lattice anchored at the origin that hold a dummy, each with its count.
inline std::map<std::array<int, 3>, int> cells(const WallDummies& dummies, double spacing) {
  std::map<std::array<int, 3>, int> held;
  for (const Vec3& p : dummies.position) {
    std::array<int, 3> cell{};
    for (std::size_t a = 0; a < 3; ++a) cell[a] = static_cast<int>(std::floor(p[a] / spacing));
    ++held[cell];
  }
  return held;
}

}  // namespace scarp::test
