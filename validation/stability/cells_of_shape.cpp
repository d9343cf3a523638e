// SPDX-License-Identifier: BSD-3-Clause
/// The axes of shape, scale and noise.
#include <algorithm>
#include <optional>

#include "validation/stability/cell_axes.hpp"
#include "validation/stability/scenes.hpp"

namespace scarp::validation {
namespace {

/// The slope, `factor` times as large.
Scene scaled_slope(const std::string& preset_name, double factor, Vec3 origin) {
  Scene scene = slope_scene(preset_name);
  scene.spacing *= factor;
  const auto at = [&](double& x, std::size_t axis) { x = origin[axis] + factor * x; };
  for (auto& point : std::get<Polygon>(scene.bodies[0].shape).points) {
    at(point[0], 0);
    at(point[1], 1);
  }
  for (Wall& wall : scene.walls) {
    for (Facet& facet : wall.facets) {
      at(facet.origin[0], 0);
      at(facet.origin[1], 1);
      facet.length_u *= factor;
    }
  }
  SoilModel& soil = scene.materials[0].model;
  soil.set("cohesion", soil.parameter("cohesion") * factor);  // c/(gamma H) stays
  soil.set("youngs_modulus", soil.parameter("youngs_modulus") * std::max(factor, 0.01));
  return scene;
}

}  // namespace

void add_shape(CellAxes& axes) {
  const auto same = [](Cell&) {};
  const CellBase column = [](const std::string& name) { return bed_scene(name, 2, 40, 0.5); };
  axes.axis({"shape", "aspect ratio", column, true, 300.0, false, true}, {{"20", same, true}});
  const CellBase layer = [](const std::string& name) { return bed_scene(name, 40, 0.5, 0.5); };
  axes.axis({"shape", "layer", layer, true, 300.0, false, true},
            {{"one particle thick", same, true}});
  const CellBase lone = [](const std::string& name) { return bed_scene(name, 1, 1, 1); };
  axes.axis({"shape", "lone particle", lone, false, 300.0, false, true},
            {{"on a base", same, true}});
  const CellBase bed = [](const std::string& name) { return bed_scene(name, 20, 5, 0.5); };
  axes.axis({"shape", "coincident", bed},
            {{"two particles", [](Cell& cell) { cell.coincident = true; }, true}});
  const auto packing = [](double share) { return [share](Cell& cell) { cell.displaced = share; }; };
  axes.axis({"shape", "packing", bed, true}, {{"up to 0.1 dx", packing(0.1)},
                                              {"up to 0.3 dx", packing(0.3)},
                                              {"up to 0.5 dx, random", packing(0.5), true}});
  const auto ratio = [](double r, std::optional<SmoothingFunction> other = {}) {
    return [r, other](Cell& cell) {
      Numerics& numerics = cell.scene.numerics;
      numerics.smoothing_ratio = r;
      if (other) numerics.smoothing = *other;
    };
  };
  constexpr SmoothingFunction wendland = SmoothingFunction::wendland_c2;
  axes.axis({"shape", "h/dx", slope_scene, true, 300.0, false, true},
            {{"1.0", ratio(1.0), true},
             {"1.5", ratio(1.5)},
             {"1.5, Wendland C2", ratio(1.5, wendland)},
             {"2.0", ratio(2.0), true},
             {"2.0, Wendland C2", ratio(2.0, wendland)}});
  const CellBase wedge = [](const std::string& name) {
    Scene scene = bed_scene(name, 10, 4, 0.4);
    scene.materials = {soil(20e6, 0, 30)};
    scene.bodies = {{.shape = Polygon{{{3, 4}, {7, 4}, {7, 8}, {3, 8}}}}};
    scene.walls = {wall_2d("left", WallKind::no_slip, {line_2d(0, 8, 4.9, -4)}),
                   wall_2d("right", WallKind::no_slip, {line_2d(5.1, -4, 10, 8)})};
    scene.initial_stress = InitialStress::zero;
    scene.stages = {lasting("fall", 1e6)};
    return scene;
  };
  axes.axis({"shape", "wedge", wedge, false, 0.0},
            {{"between converging walls", [](Cell& cell) { cell.steps = 6000; }, true}});
  const CellBase corner = [](const std::string& name) {
    Scene scene = bed_scene(name, 8, 8, 0.4);
    scene.materials = {soil(20e6, 0, 30)};
    scene.walls = {wall_2d("ground", WallKind::no_slip,
                           {line_2d(0, 0, 12, 0), line_2d(12, 0, 12, -4), line_2d(12, -4, 60, -4)}),
                   wall_2d("back", WallKind::free_slip, {line_2d(0, 20, 0, 0)})};
    scene.stages = {lasting("run out", 1e6)};
    return scene;
  };
  axes.axis({"shape", "run-out over a corner", corner, false, 0.0},
            {{"2 m deep sand", [](Cell& cell) { cell.steps = 6000; }, true}});
  const auto plate = [](double thickness) {
    return [thickness](Cell& cell) {
      const double x = 10.0;
      cell.scene.bodies = {box_of("soil", 0, 0, x, 5), box_of("soil", x + thickness, 0, 20, 2)};
      cell.scene.walls.push_back(
          wall_2d("plate", WallKind::no_slip,
                  {line_2d(x, 0, x, 20), line_2d(x + thickness, 20, x + thickness, 0)}));
    };
  };
  axes.axis({"shape", "wall thickness", bed, true, 300.0, false, true},
            {{"1 dx", plate(0.5), true}, {"2 dx", plate(1.0)}, {"4 dx", plate(2.0)}});
}

void add_scale(CellAxes& axes) {
  const auto sized = [](double factor, Vec3 origin) {
    return [=](Cell& cell) {
      const Precision precision = cell.scene.numerics.precision;
      cell.scene = scaled_slope(cell.scene.numerics.preset, factor, origin);
      cell.scene.numerics.precision = precision;
    };
  };
  axes.axis({"scale", "size", slope_scene, true, 300.0, true, true},
            {{"1 cm box", sized(0.01 / 45, {0, 0, 0}), true},
             {"10 km valley", sized(1e4 / 45, {0, 0, 0}), true}});
  axes.axis({"scale", "place", slope_scene, true, 300.0, true, true},
            {{"10^6 m from the origin", sized(1.0, {1e6, -1e6, 0}), true}});
  const auto dense = [](double density) {
    return material(soil(100e6, 10e3, 20, 0, 0.3, density));
  };
  axes.axis({"scale", "density", slope_scene, true},
            {{"1 kg/m3", dense(1.0), true}, {"2*10^4 kg/m3", dense(2e4), true}});
}

void let_slide(Cell& cell, double factor) {
  set_stages(cell.scene, 300.0 * factor);
  cell.scene.stages[1].strength_reduction = 1.5;
  cell.scene.stages[1].duration = 5.0;
  cell.steps = 200000;
}

void add_noise(CellAxes& axes) {
  const auto refined = [](double factor) {
    return [factor](Cell& cell) {
      cell.scene.spacing /= factor;
      let_slide(cell, factor);
    };
  };
  axes.axis({"noise", "slope at SRF 1.5", slope_scene, false, 0.0},
            {{"dx 1 m", refined(1), true}, {"dx 0.5 m", refined(2)}, {"dx 0.25 m", refined(4)}});
  const CellBase column = [](const std::string& name) {
    Scene scene = bed_scene(name, 4, 8, 0.4);
    scene.materials = {soil(10e6, 0, 30)};
    scene.walls = {wall_2d("ground", WallKind::no_slip, {line_2d(0, 0, 40, 0)}),
                   wall_2d("back", WallKind::free_slip, {line_2d(0, 20, 0, 0)})};
    scene.stages = {lasting("collapse", 5.0)};
    return scene;
  };
  axes.axis({"noise", "column after its collapse", column, false, 0.0},
            {{"dx 0.4 m", finer(1), true}, {"dx 0.2 m", finer(2)}, {"dx 0.1 m", finer(4)}});
}

}  // namespace scarp::validation
