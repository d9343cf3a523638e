// SPDX-License-Identifier: BSD-3-Clause
/// The axes of stiffness, strength and loading.
#include "validation/stability/cells.hpp"

#include <algorithm>

#include "validation/stability/cell_axes.hpp"
#include "validation/stability/scenes.hpp"

namespace scarp::validation {
namespace {

CellChange youngs(double e) {
  return [e](Cell& cell) { cell.scene.materials[0].model.set("youngs_modulus", e); };
}

void add_stiffness(CellAxes& axes) {
  const CellAxes::Axis e{"stiffness", "E", slope_scene, true, 300.0, true, true};
  axes.axis(e, {{"10 kPa", youngs(1e4), true},
                {"100 kPa", youngs(1e5)},
                {"1 MPa", youngs(1e6)},
                {"10 MPa", youngs(1e7)},
                {"100 MPa", youngs(1e8), true},
                {"1 GPa", youngs(1e9)},
                {"10 GPa", youngs(1e10)},
                {"100 GPa", youngs(1e11), true}});
  const auto poisson = [](double nu) { return material(soil(100e6, 10e3, 20, 0, nu)); };
  axes.axis({"stiffness", "nu", slope_scene, true, 300.0, false, true},
            {{"0", poisson(0.0)},
             {"0.45", poisson(0.45)},
             {"0.49", poisson(0.49)},
             {"0.499", poisson(0.499), true}});
  // A layer of the other material under or above the soil; the stiff one's inertia so many times
  // its mass.
  const auto layered = [](double youngs_below, double youngs_above, double scaling = 1.0) {
    return [=](Cell& cell) {
      Material below = soil(youngs_below), above = soil(youngs_above);
      below.name = "below";
      above.name = "above";
      (youngs_below > youngs_above ? below : above).mass_scaling = scaling;
      if (scaling > 1.0) cell.scene.numerics.artificial_stress = 0.0;
      cell.scene.materials = {below, above};
      cell.scene.bodies = {box_of("below", 0, 0, 20, 3), box_of("above", 0, 3, 20, 6)};
    };
  };
  const CellBase bed = [](const std::string& name) { return bed_scene(name, 20, 6, 0.5); };
  axes.axis({"stiffness", "contrast", bed, true, 300.0, false, true},
            {{"10^4, stiff below", layered(1e10, 1e6), true},
             {"10^4, stiff above", layered(1e6, 1e10)},
             {"stiff below, mass x 10^4", layered(1e10, 1e6, 1e4), true},
             {"stiff above, mass x 100", layered(1e6, 1e10, 100.0)}});
}

void add_strength(CellAxes& axes) {
  const auto phi = [](double degrees) { return material(soil(100e6, 10e3, degrees)); };
  axes.axis({"strength", "phi", slope_scene, true}, {{"0 deg", phi(0), true},
                                                     {"10 deg", phi(10)},
                                                     {"30 deg", phi(30)},
                                                     {"50 deg", phi(50), true}});
  const auto psi = [](double degrees) { return material(soil(100e6, 10e3, 30, degrees)); };
  axes.axis({"strength", "psi at phi 30", slope_scene, true},
            {{"0 deg", psi(0)}, {"15 deg", psi(15)}, {"30 deg", psi(30), true}});
  const auto cohesion = [](double c) { return material(soil(100e6, c)); };
  axes.axis({"strength", "c", slope_scene, true}, {{"0", cohesion(0.0), true},
                                                   {"1 kPa", cohesion(1e3)},
                                                   {"100 kPa", cohesion(1e5)},
                                                   {"1 MPa", cohesion(1e6), true}});
  axes.axis({"strength", "c = phi = 0", slope_scene, true},
            {{"no strength", material(soil(100e6, 0, 0)), true}});
  const auto reduction = [](double factor) {
    return [factor](Cell& cell) {
      set_stages(cell.scene, 300.0);
      cell.scene.stages[1].strength_reduction = factor;
    };
  };
  axes.axis(
      {"strength", "SRF at once", slope_scene, true, 0.0},
      {{"1", reduction(1)}, {"2", reduction(2)}, {"5", reduction(5)}, {"10", reduction(10), true}});
  const auto pulled = [](double speed) {
    return [speed](Cell& cell) {
      Scene& scene = cell.scene;
      scene.walls.clear();
      scene.gravity = {0, 0, 0};
      scene.initial_stress = InitialStress::zero;
      scene.bodies = {box_of("soil", 0, 0, 10, 5, speed), box_of("soil", 0, 5, 10, 10, -speed)};
      scene.stages = {lasting("go", 1e6)};
    };
  };
  const CellBase block = [](const std::string& name) { return bed_scene(name, 10, 10, 0.5); };
  axes.axis({"strength", "tension at the apex", block, false, 0.0},
            {{"pulled at 0.1 m/s", pulled(0.1)}, {"pulled at 5 m/s", pulled(5.0), true}});
}

void add_loading(CellAxes& axes) {
  const CellBase small = [](const std::string& name) { return bed_scene(name, 5, 4, 0.5); };
  const auto rest = [](std::uint64_t steps) { return [steps](Cell& cell) { cell.steps = steps; }; };
  axes.axis({"loading", "rest", small, false, 2000.0, true, true},
            {{"10^6 steps", rest(1000000), true}});
  const auto moving = [](double gap, double speed, bool dry) {
    return [=](Cell& cell) {
      Scene& scene = cell.scene;
      scene.materials = {soil(20e6, dry ? 0.0 : 10e3, 30), solid("block", 100e6)};
      scene.bodies.push_back(box_of("block", 8, 3 + gap, 12, 5 + gap, speed));
      scene.initial_stress = InitialStress::zero;
      scene.stages = {lasting("go", 1e6)};
      cell.steps = 4000;
    };
  };
  const CellBase bed = [](const std::string& name) { return bed_scene(name, 20, 3, 0.4); };
  axes.axis({"loading", "drop", bed, false, 0.0},
            {{"from 1 m", moving(1.2, 0, true)}, {"from 20 m", moving(2.0, 19.8, true), true}});
  axes.axis({"loading", "impact", bed, false, 0.0}, {{"1 m/s", moving(0.8, 1, false)},
                                                     {"10 m/s", moving(0.8, 10, false)},
                                                     {"100 m/s", moving(0.8, 100, false)},
                                                     {"300 m/s", moving(0.8, 300, false), true}});
  axes.axis({"loading", "gravity", slope_scene, true}, {{"100 g",
                                                         [](Cell& cell) {
                                                           cell.scene.gravity = {0, -981, 0};
                                                         },
                                                         true}});
  const CellBase held = [](const std::string& name) { return bed_scene(name, 10, 10, 0.5); };
  axes.axis(
      {"loading", "support removed", held, false, 0.0},
      {{"at once",
        [](Cell& cell) {
          Scene& scene = cell.scene;
          scene.walls[1].facets.pop_back();
          scene.walls.push_back(wall_2d("gate", WallKind::free_slip, {line_2d(10, 0, 10, 20)}));
          scene.walls[0].facets = {line_2d(0, 0, 60, 0)};
          set_stages(scene, 300.0);
          scene.walls[2].removed_at = "go";
          cell.steps = 4000;
        },
        true}});
  const CellBase disc = [](const std::string& name) {
    Scene scene = bed_scene(name, 2, 2, 0.1);
    scene.walls.clear();
    scene.gravity = {0, 0, 0};
    scene.initial_stress = InitialStress::zero;
    scene.materials = {solid("disc", 10e6)};
    Body body{.shape = Cylinder{{0, 0, 0}, 1.0}};
    body.velocity_field = {"-2*pi*y", "2*pi*x"};
    scene.bodies = {body};
    scene.stages = {lasting("turn", 10.0)};
    return scene;
  };
  axes.axis({"loading", "rotation", disc, false, 0.0},
            {{"10 turns", [](Cell& cell) { cell.steps = 200000; }, true}});
}

}  // namespace

std::vector<Cell> stability_cells(bool short_form) {
  CellAxes axes(short_form);
  add_stiffness(axes);
  add_strength(axes);
  add_loading(axes);
  add_shape(axes);
  add_scale(axes);
  add_noise(axes);
  add_3d(axes);
  return axes.take();
}

}  // namespace scarp::validation
