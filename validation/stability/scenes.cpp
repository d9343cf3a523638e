// SPDX-License-Identifier: BSD-3-Clause
/// The base scenes and their parts.
#include "validation/stability/scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/check/stability_margin.hpp"
#include "engine/scene/facets.hpp"
#include "engine/scene/shape_list.hpp"
#include "engine/scene/smoothing_choice.hpp"

namespace scarp::validation {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// Of all bodies [m].
double height_of(const Scene& scene) {
  const std::size_t up = upwards(scene);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Body& body : scene.bodies) {
    const ShapeExtent extent = row_of(body.shape).extent(body.shape, scene.dimension);
    low = std::min(low, extent.minimum[up]);
    high = std::max(high, extent.maximum[up]);
  }
  return high - low;
}

}  // namespace

std::size_t upwards(const Scene& scene) { return scene.dimension == 2 ? 1 : 2; }

Stage lasting(const std::string& name, double duration) {
  Stage stage;
  stage.name = name;
  stage.duration = duration;
  return stage;
}

Facet line_2d(double x0, double y0, double x1, double y1) {
  const double length = std::hypot(x1 - x0, y1 - y0);
  const double tx = (x1 - x0) / length, ty = (y1 - y0) / length;
  return {{x0, y0, 0}, {tx, ty, 0}, {0, 0, 0}, length, 0.0, {-ty, tx, 0}};
}

Wall wall_2d(const std::string& name, WallKind kind, std::vector<Facet> facets) {
  Wall wall;
  wall.name = name;
  wall.kind = kind;
  wall.facets = std::move(facets);
  return wall;
}

Material soil(double youngs, double cohesion, double friction_deg, double dilation_deg,
              double poisson, double density) {
  return {"soil",
          DruckerPrager{youngs, poisson, cohesion, friction_deg * degree, dilation_deg * degree,
                        Cone::plane_strain},
          density};
}

Body box_of(const std::string& material, double x0, double y0, double x1, double y1,
            double falling) {
  Body body;
  body.material = material;
  body.shape = Box{{x0, y0, 0}, {x1, y1, 0}};
  body.velocity = {0, -falling, 0};
  return body;
}

Material solid(const std::string& name, double youngs, double density) {
  return {name, LinearElastic{youngs, 0.3}, density};
}

void set_stages(Scene& scene, double settle_passages) {
  const double passage = smoothing_length_of(scene) / sound_speed(scene);
  Stage settle = lasting("settle", settle_passages * passage);
  settle.until = StageEnd::rest;
  settle.reset_after = true;
  settle.rest_velocity = 1e-7 * sound_speed(scene);  // calmer than the shake of the trials
  scene.stages = {settle, lasting("go", 1e6)};
}

bool can_stand(const Scene& scene) {
  const double weight = std::abs(scene.gravity[upwards(scene)]) * height_of(scene);
  return std::all_of(scene.materials.begin(), scene.materials.end(), [&](const Material& m) {
    return m.density * weight < m.model.moduli().wave_modulus();
  });
}

void settle_fully(Scene& scene) {
  const Material* slowest = nullptr;
  double fastest = 0.0, inertia = 1.0;
  for (const Material& material : scene.materials) {
    if (slowest == nullptr || material.sound_speed() < slowest->sound_speed()) slowest = &material;
    fastest = std::max(fastest, material.sound_speed());
    inertia = std::max(inertia, material.mass_scaling);
  }
  const double height = height_of(scene), pressure_wave = slowest->sound_speed(),
               shear_wave = std::sqrt(slowest->model.moduli().shear_modulus /
                                      (slowest->mass_scaling * slowest->density));
  // c_d = pi c_p/(2 H) is more than critical for the first shear wave, omega = pi c_s/(2 H): it
  // goes with exp(-omega^2 t/c_d). With a scaled lid on soft soil both are slower by up to the
  // root.
  Stage& settle = scene.stages[0];
  const double times = 2.0 * height / std::numbers::pi * pressure_wave / (shear_wave * shear_wave);
  settle.duration = std::max(*settle.duration, 10.0 * std::sqrt(inertia) * times);
  // What is out of balance then, c_d v, gives the speed c_d v/omega without damping: a hundredth of
  // what a cell that stands may have.
  const double still = 1e-4 * std::sqrt(std::abs(scene.gravity[upwards(scene)]) * height);
  settle.rest_velocity = std::min(1e-7 * fastest, 0.01 * still * shear_wave / pressure_wave);
}

Scene slope_scene(const std::string& preset_name) {
  Scene scene;
  scene.spacing = 1.0;
  scene.numerics = preset(preset_name);
  scene.materials = {soil()};
  scene.bodies = {{.shape = Polygon{{{0, 0}, {45, 0}, {45, 5}, {32, 5}, {12, 15}, {0, 15}}}}};
  scene.walls = {
      wall_2d("base", WallKind::no_slip, {line_2d(0, 0, 45, 0)}),
      wall_2d("sides", WallKind::free_slip, {line_2d(0, 20, 0, 0), line_2d(45, 0, 45, 20)})};
  scene.initial_stress = InitialStress::geostatic;
  set_stages(scene, 300.0);
  return scene;
}

Scene bed_scene(const std::string& preset_name, double width, double height, double spacing) {
  Scene scene;
  scene.spacing = spacing;
  scene.numerics = preset(preset_name);
  scene.materials = {soil()};
  scene.bodies = {box_of("soil", 0, 0, width, height)};
  const double top = 4.0 * height;
  scene.walls = {wall_2d("base", WallKind::no_slip, {line_2d(0, 0, width, 0)}),
                 wall_2d("sides", WallKind::free_slip,
                         {line_2d(0, top, 0, 0), line_2d(width, 0, width, top)})};
  scene.initial_stress = InitialStress::geostatic;
  set_stages(scene, 300.0);
  return scene;
}

Scene bed_scene_3d(const std::string& preset_name, double width, double height, double spacing) {
  Scene scene;
  scene.dimension = 3;
  scene.gravity = {0.0, 0.0, -9.81};
  scene.spacing = spacing;
  scene.numerics = preset(preset_name);
  scene.materials = {soil()};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {width, width, height}}}};
  const Box room{{0, 0, 0}, {width, width, 2.0 * height}};
  Wall base{.name = "base", .kind = WallKind::no_slip};
  Wall sides{.name = "sides", .kind = WallKind::free_slip};
  base.facets = box_facets(room, {"-x", "+x", "-y", "+y", "+z"}, 3);
  sides.facets = box_facets(room, {"-z", "+z"}, 3);
  scene.walls = {base, sides};
  scene.initial_stress = InitialStress::geostatic;
  set_stages(scene, 300.0);
  return scene;
}

}  // namespace scarp::validation
