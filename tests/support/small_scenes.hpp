// SPDX-License-Identifier: BSD-3-Clause
/// Small scenes that the tests of the engine share.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "engine/simulation.hpp"

namespace scarp::test {

inline Stage stage_for(const std::string& name, double duration) {
  Stage stage;
  stage.name = name;
  stage.duration = duration;
  return stage;
}

inline Facet facet_2d(double x0, double y0, double x1, double y1) {
  const double length = std::hypot(x1 - x0, y1 - y0), tx = (x1 - x0) / length,
               ty = (y1 - y0) / length;
  return {{x0, y0, 0}, {tx, ty, 0}, {0, 0, 0}, length, 0.0, {-ty, tx, 0}};
}

inline Wall wall_of(const std::string& name, WallKind kind, std::vector<Facet> facets) {
  Wall wall;
  wall.name = name;
  wall.kind = kind;
  wall.facets = std::move(facets);
  return wall;
}

inline Material clay() {
  return {"clay", DruckerPrager{100e6, 0.3, 10e3, 0.349, 0.157, Cone::plane_strain}, 2000.0};
}
inline Material elastic(double youngs_modulus = 10e6) {
  return {"elastic", LinearElastic{youngs_modulus, 0.3}, 2000.0};
}

/// Elastic column 1 m x `height` between smooth sides on a smooth base, loaded by its weight and
/// damped.
inline Scene elastic_column(const std::string& preset_name, double height, double spacing) {
  Scene scene;
  scene.spacing = spacing;
  scene.numerics = preset(preset_name);
  scene.materials = {elastic()};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {1, height, 0}}}};
  scene.walls = {wall_of(
      "box", WallKind::free_slip,
      {facet_2d(0, 0, 1, 0), facet_2d(1, 0, 1, height + 1), facet_2d(0, height + 1, 0, 0)})};
  Stage settle = stage_for("settle", 30.0);
  settle.until = StageEnd::rest;
  settle.rest_velocity = 1e-6;
  settle.damping = 15.0;
  scene.stages = {settle};
  return scene;
}

/// A coarse slope on a rough base between smooth sides: settles for `settle` seconds, then fails.
inline Scene small_slope(const std::string& preset_name, double settle, double fail,
                         double reduction) {
  Scene scene;
  scene.spacing = 1.0;
  scene.numerics = preset(preset_name);
  scene.materials = {clay()};
  scene.bodies = {{.shape = Polygon{{{0, 0}, {45, 0}, {45, 5}, {32, 5}, {12, 15}, {0, 15}}}}};
  scene.walls = {wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 45, 0)}),
                 wall_of("left", WallKind::free_slip, {facet_2d(0, 20, 0, 0)}),
                 wall_of("right", WallKind::free_slip, {facet_2d(45, 0, 45, 20)})};
  scene.initial_stress = InitialStress::geostatic;
  Stage first = stage_for("settle", settle);
  first.damping = 27.0;
  first.reset_after = true;
  Stage second = stage_for("fail", fail);
  second.strength_reduction = reduction;
  scene.stages = {first, second};
  Probe crest;
  crest.name = "crest";
  crest.at = {12, 15, 0};
  scene.probes = {crest};
  return scene;
}

/// A bed of sand on a rough base, between a smooth wall on the left and a rough one on the right,
/// and a grain that falls on it and against the left wall at many times the speed of all others.
inline Scene bed_and_grain(const std::string& preset_name) {
  Scene scene;
  scene.spacing = 0.1;
  scene.numerics = preset(preset_name);
  scene.materials = {{"sand", DruckerPrager{2e6, 0.3, 0.0, 0.52, 0.0, Cone::plane_strain}, 2000.0}};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {5, 0.8, 0}}},
                  {.shape = Box{{0.8, 1.3, 0}, {0.9, 1.4, 0}}, .velocity = {-10.0, -8.0, 0.0}}};
  scene.walls = {wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 5, 0)}),
                 wall_of("left", WallKind::free_slip, {facet_2d(0, 9, 0, 0)}),
                 wall_of("right", WallKind::no_slip, {facet_2d(5, 0, 5, 9)})};
  scene.initial_stress = InitialStress::geostatic;
  scene.stages = {stage_for("fall", 10.0)};
  return scene;
}

/// A block of sand behind a gate that is removed, on a rough base, 3D.
inline Scene small_collapse(const std::string& preset_name, double spacing, double duration) {
  Scene scene;
  scene.dimension = 3;
  scene.gravity = {0, 0, -9.81};
  scene.spacing = spacing;
  scene.numerics = preset(preset_name);
  scene.materials = {{"sand", DruckerPrager{2e6, 0.25, 0.0, 0.576, 0.0, Cone::outer}, 1530.0}};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {0.24, 0.16, 0.16}}}};
  const auto face = [](Vec3 origin, Vec3 u, Vec3 v, double length_u, double length_v, Vec3 normal) {
    return Facet{origin, u, v, length_u, length_v, normal};
  };
  scene.walls = {wall_of("base", WallKind::no_slip,
                         {face({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0.96, 0.16, {0, 0, 1})}),
                 wall_of("sides", WallKind::free_slip,
                         {face({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0.32, 0.96, {0, 1, 0}),
                          face({0, 0.16, 0}, {1, 0, 0}, {0, 0, 1}, 0.96, 0.32, {0, -1, 0}),
                          face({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.16, 0.32, {1, 0, 0})}),
                 wall_of("gate", WallKind::free_slip,
                         {face({0.24, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0.32, 0.16, {-1, 0, 0})})};
  scene.walls[2].removed_at = "collapse";
  scene.initial_stress = InitialStress::geostatic;
  Stage fill = stage_for("fill", 0.02);
  fill.damping = 500.0;
  fill.reset_after = true;
  scene.stages = {fill, stage_for("collapse", duration)};
  return scene;
}

inline Simulation run_steps(Scene scene, int steps, RunOptions options = {}) {
  Simulation simulation(std::move(scene), std::move(options));
  for (int k = 0; k < steps && !simulation.finished(); ++k) simulation.step();
  return simulation;
}

}  // namespace scarp::test
