// SPDX-License-Identifier: BSD-3-Clause
/// The axes in 3D, where lattices and supports have other limits than in 2D.
#include "engine/scene/facets.hpp"
#include "validation/stability/cell_axes.hpp"
#include "validation/stability/scenes.hpp"

namespace scarp::validation {

namespace {

/// The plane slope, four spacings wide between smooth planes.
Scene slope_strip(const std::string& preset_name, double spacing) {
  Scene scene = bed_scene_3d(preset_name, 45.0, 15.0, spacing);
  auto outline = std::get<Polygon>(slope_scene(preset_name).bodies[0].shape);
  outline.extrude = {0.0, 4.0 * spacing};
  scene.bodies = {{.shape = outline}};
  const Box room{{0, 0, 0}, {45, outline.extrude[1], 20}};
  scene.walls[0].facets = box_facets(room, {"-x", "+x", "-y", "+y", "+z"}, 3);
  scene.walls[1].facets = box_facets(room, {"-z", "+z"}, 3);
  return scene;
}

}  // namespace

void add_3d(CellAxes& axes) {
  const CellBase bed = [](const std::string& name) { return bed_scene_3d(name, 4.0, 8.0, 0.5); };
  const auto elastic = [](double youngs, double poisson) {
    return material(soil(youngs, 10e3, 20, 0, poisson));
  };
  axes.axis({"3D", "E and nu, bed", bed, true, 300.0, true, true},
            {{"10 MPa", elastic(10e6, 0.3), true},
             {"100 MPa", elastic(100e6, 0.3)},
             {"10 GPa", elastic(10e9, 0.3)},
             {"100 MPa, 0.49", elastic(100e6, 0.49)}});
  const auto smooth = [&](SmoothingFunction function, double ratio) {
    return [=](Cell& cell) {
      elastic(10e6, 0.3)(cell);
      cell.steps = 8000;  // for what grows from rest
      cell.scene.numerics.smoothing = function;
      cell.scene.numerics.smoothing_ratio = ratio;
    };
  };
  axes.axis({"3D", "W and h/dx, bed", bed, false, 300.0, false, true},
            {{"cubic spline 1.2", smooth(SmoothingFunction::cubic_spline, 1.2), true},
             {"cubic spline 1.5", smooth(SmoothingFunction::cubic_spline, 1.5)},
             {"Yang and Liu 1.4", smooth(SmoothingFunction::yang_liu, 1.4)},
             {"Wendland C2 1.5", smooth(SmoothingFunction::wendland_c2, 1.5)}});
  const auto layered = [](double below, double above) {
    return [=](Cell& cell) {
      Material low = soil(below), high = soil(above);
      low.name = "below";
      high.name = "above";
      cell.scene.materials = {low, high};
      cell.scene.bodies = {{.shape = Box{{0, 0, 0}, {4, 4, 4}}, .material = "below"},
                           {.shape = Box{{0, 0, 4}, {4, 4, 8}}, .material = "above"}};
    };
  };
  axes.axis(
      {"3D", "contrast, bed", bed, true, 300.0, false, true},
      {{"100, stiff below", layered(1e9, 1e7), true}, {"100, stiff above", layered(1e7, 1e9)}});
  const CellBase column = [](const std::string& name) {
    Scene scene = bed_scene_3d(name, 2.0, 4.0, 0.2);
    scene.materials = {soil(10e6, 0, 30)};
    const Box ground{{0, 0, 0}, {12, 12, 8}};  // of a quarter
    scene.walls[0].facets = box_facets(ground, {"-x", "+x", "-y", "+y", "+z"}, 3);
    scene.walls[1].facets = box_facets(ground, {"+x", "+y", "-z", "+z"}, 3);
    scene.stages = {lasting("collapse", 4.0)};
    return scene;
  };
  axes.axis({"noise", "3D column after its collapse", column, false, 0.0},
            {{"dx 0.2 m", finer(1), true}, {"dx 0.13 m", finer(1.5)}});
  const auto strip = [](double spacing) {
    return [spacing](Cell& cell) {
      const Precision precision = cell.scene.numerics.precision;
      cell.scene = slope_strip(cell.scene.numerics.preset, spacing);
      cell.scene.numerics.precision = precision;
      let_slide(cell, 1.0 / spacing);
    };
  };
  const CellBase slope = [](const std::string& name) { return slope_strip(name, 1.0); };
  axes.axis({"noise", "3D strip of the slope at SRF 1.5", slope, false, 0.0},
            {{"dx 1 m", strip(1.0), true}, {"dx 0.5 m", strip(0.5)}});
}

}  // namespace scarp::validation
