// SPDX-License-Identifier: BSD-3-Clause
/// The axes.
#include "validation/stability/cells.hpp"

#include <algorithm>
#include <functional>
#include <optional>

#include "validation/stability/scenes.hpp"

namespace scarp::validation {
namespace {

using Change = std::function<void(Cell&)>;
using Build = std::function<Scene(const std::string&)>;

struct Point {
  std::string value;
  Change change;
  bool in_short = false;
};

class Map {
 public:
  explicit Map(bool short_form) : short_(short_form) {}

  struct Axis {
    std::string group, name;
    Build base;
    bool bisect = false;
    double settle = 300.0;  ///< passages; 0: the scene's own stages
    bool mixed = false;     ///< with mixed precision too
    bool stands = false;    ///< nothing should move in the end
  };

  void axis(const Axis& axis, const std::vector<Point>& points) {
    for (const Point& point : points) {
      if (short_ && !point.in_short) continue;
      for (const char* name : {"modern", "paper"}) add(axis, point, name, Precision::real64);
      if (axis.mixed) add(axis, point, "modern", Precision::mixed);
    }
  }

  std::vector<Cell> take() { return std::move(cells_); }

 private:
  void add(const Axis& axis, const Point& point, const std::string& preset_name,
           Precision precision) {
    Cell cell{axis.group, axis.name, point.value, axis.base(preset_name)};
    cell.bisect = axis.bisect;
    cell.scene.numerics.precision = precision;
    point.change(cell);
    if (axis.settle > 0.0) set_stages(cell.scene, axis.settle);
    cell.stands = axis.stands && can_stand(cell.scene);
    if (cell.stands) settle_fully(cell.scene);
    if (short_) cell.steps = std::min<std::uint64_t>(cell.steps / 4, 5000);
    cells_.push_back(std::move(cell));
  }

  bool short_;
  std::vector<Cell> cells_;
};

Change youngs(double e) {
  return [e](Cell& cell) { cell.scene.materials[0].model.set("youngs_modulus", e); };
}
Change material(const Material& m) {
  return [m](Cell& cell) { cell.scene.materials[0] = m; };
}

void add_stiffness(Map& map) {
  const Map::Axis e{"stiffness", "E", slope_scene, true, 300.0, true, true};
  map.axis(e, {{"10 kPa", youngs(1e4), true},
               {"100 kPa", youngs(1e5)},
               {"1 MPa", youngs(1e6)},
               {"10 MPa", youngs(1e7)},
               {"100 MPa", youngs(1e8), true},
               {"1 GPa", youngs(1e9)},
               {"10 GPa", youngs(1e10)},
               {"100 GPa", youngs(1e11), true}});
  const auto poisson = [](double nu) { return material(soil(100e6, 10e3, 20, 0, nu)); };
  map.axis({"stiffness", "nu", slope_scene, true, 300.0, false, true},
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
  const Build bed = [](const std::string& name) { return bed_scene(name, 20, 6, 0.5); };
  map.axis({"stiffness", "contrast", bed, true, 300.0, false, true},
           {{"10^4, stiff below", layered(1e10, 1e6), true},
            {"10^4, stiff above", layered(1e6, 1e10)},
            {"stiff below, mass x 10^4", layered(1e10, 1e6, 1e4), true},
            {"stiff above, mass x 100", layered(1e6, 1e10, 100.0)}});
}

void add_strength(Map& map) {
  const auto phi = [](double degrees) { return material(soil(100e6, 10e3, degrees)); };
  map.axis({"strength", "phi", slope_scene, true}, {{"0 deg", phi(0), true},
                                                    {"10 deg", phi(10)},
                                                    {"30 deg", phi(30)},
                                                    {"50 deg", phi(50), true}});
  const auto psi = [](double degrees) { return material(soil(100e6, 10e3, 30, degrees)); };
  map.axis({"strength", "psi at phi 30", slope_scene, true},
           {{"0 deg", psi(0)}, {"15 deg", psi(15)}, {"30 deg", psi(30), true}});
  const auto cohesion = [](double c) { return material(soil(100e6, c)); };
  map.axis({"strength", "c", slope_scene, true}, {{"0", cohesion(0.0), true},
                                                  {"1 kPa", cohesion(1e3)},
                                                  {"100 kPa", cohesion(1e5)},
                                                  {"1 MPa", cohesion(1e6), true}});
  map.axis({"strength", "c = phi = 0", slope_scene, true},
           {{"no strength", material(soil(100e6, 0, 0)), true}});
  const auto reduction = [](double factor) {
    return [factor](Cell& cell) {
      set_stages(cell.scene, 300.0);
      cell.scene.stages[1].strength_reduction = factor;
    };
  };
  map.axis(
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
  const Build block = [](const std::string& name) { return bed_scene(name, 10, 10, 0.5); };
  map.axis({"strength", "tension at the apex", block, false, 0.0},
           {{"pulled at 0.1 m/s", pulled(0.1)}, {"pulled at 5 m/s", pulled(5.0), true}});
}

void add_loading(Map& map) {
  const Build small = [](const std::string& name) { return bed_scene(name, 5, 4, 0.5); };
  const auto rest = [](std::uint64_t steps) { return [steps](Cell& cell) { cell.steps = steps; }; };
  map.axis({"loading", "rest", small, false, 2000.0, true, true},
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
  const Build bed = [](const std::string& name) { return bed_scene(name, 20, 3, 0.4); };
  map.axis({"loading", "drop", bed, false, 0.0},
           {{"from 1 m", moving(1.2, 0, true)}, {"from 20 m", moving(2.0, 19.8, true), true}});
  map.axis({"loading", "impact", bed, false, 0.0}, {{"1 m/s", moving(0.8, 1, false)},
                                                    {"10 m/s", moving(0.8, 10, false)},
                                                    {"100 m/s", moving(0.8, 100, false)},
                                                    {"300 m/s", moving(0.8, 300, false), true}});
  map.axis({"loading", "gravity", slope_scene, true}, {{"100 g",
                                                        [](Cell& cell) {
                                                          cell.scene.gravity = {0, -981, 0};
                                                        },
                                                        true}});
  const Build held = [](const std::string& name) { return bed_scene(name, 10, 10, 0.5); };
  map.axis(
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
  const Build disc = [](const std::string& name) {
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
  map.axis({"loading", "rotation", disc, false, 0.0},
           {{"10 turns", [](Cell& cell) { cell.steps = 200000; }, true}});
}

void add_shape(Map& map) {
  const auto same = [](Cell&) {};
  const Build column = [](const std::string& name) { return bed_scene(name, 2, 40, 0.5); };
  map.axis({"shape", "aspect ratio", column, true, 300.0, false, true}, {{"20", same, true}});
  const Build layer = [](const std::string& name) { return bed_scene(name, 40, 0.5, 0.5); };
  map.axis({"shape", "layer", layer, true, 300.0, false, true},
           {{"one particle thick", same, true}});
  const Build lone = [](const std::string& name) { return bed_scene(name, 1, 1, 1); };
  map.axis({"shape", "lone particle", lone, false, 300.0, false, true},
           {{"on a base", same, true}});
  const Build bed = [](const std::string& name) { return bed_scene(name, 20, 5, 0.5); };
  map.axis({"shape", "coincident", bed},
           {{"two particles", [](Cell& cell) { cell.coincident = true; }, true}});
  const auto packing = [](double share) { return [share](Cell& cell) { cell.displaced = share; }; };
  map.axis({"shape", "packing", bed, true}, {{"up to 0.1 dx", packing(0.1)},
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
  map.axis({"shape", "h/dx", slope_scene, true, 300.0, false, true},
           {{"1.0", ratio(1.0), true},
            {"1.5", ratio(1.5)},
            {"1.5, Wendland C2", ratio(1.5, wendland)},
            {"2.0", ratio(2.0), true},
            {"2.0, Wendland C2", ratio(2.0, wendland)}});
  const Build wedge = [](const std::string& name) {
    Scene scene = bed_scene(name, 10, 4, 0.4);
    scene.materials = {soil(20e6, 0, 30)};
    scene.bodies = {{.shape = Polygon{{{3, 4}, {7, 4}, {7, 8}, {3, 8}}}}};
    scene.walls = {wall_2d("left", WallKind::no_slip, {line_2d(0, 8, 4.9, -4)}),
                   wall_2d("right", WallKind::no_slip, {line_2d(5.1, -4, 10, 8)})};
    scene.initial_stress = InitialStress::zero;
    scene.stages = {lasting("fall", 1e6)};
    return scene;
  };
  map.axis({"shape", "wedge", wedge, false, 0.0},
           {{"between converging walls", [](Cell& cell) { cell.steps = 6000; }, true}});
  const Build corner = [](const std::string& name) {
    Scene scene = bed_scene(name, 8, 8, 0.4);
    scene.materials = {soil(20e6, 0, 30)};
    scene.walls = {wall_2d("ground", WallKind::no_slip,
                           {line_2d(0, 0, 12, 0), line_2d(12, 0, 12, -4), line_2d(12, -4, 60, -4)}),
                   wall_2d("back", WallKind::free_slip, {line_2d(0, 20, 0, 0)})};
    scene.stages = {lasting("run out", 1e6)};
    return scene;
  };
  map.axis({"shape", "run-out over a corner", corner, false, 0.0},
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
  map.axis({"shape", "wall thickness", bed, true, 300.0, false, true},
           {{"1 dx", plate(0.5), true}, {"2 dx", plate(1.0)}, {"4 dx", plate(2.0)}});
}

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

void add_scale(Map& map) {
  const auto sized = [](double factor, Vec3 origin) {
    return [=](Cell& cell) {
      const Precision precision = cell.scene.numerics.precision;
      cell.scene = scaled_slope(cell.scene.numerics.preset, factor, origin);
      cell.scene.numerics.precision = precision;
    };
  };
  map.axis({"scale", "size", slope_scene, true, 300.0, true, true},
           {{"1 cm box", sized(0.01 / 45, {0, 0, 0}), true},
            {"10 km valley", sized(1e4 / 45, {0, 0, 0}), true}});
  map.axis({"scale", "place", slope_scene, true, 300.0, true, true},
           {{"10^6 m from the origin", sized(1.0, {1e6, -1e6, 0}), true}});
  const auto dense = [](double density) {
    return material(soil(100e6, 10e3, 20, 0, 0.3, density));
  };
  map.axis({"scale", "density", slope_scene, true},
           {{"1 kg/m3", dense(1.0), true}, {"2*10^4 kg/m3", dense(2e4), true}});
}

/// After failure, under refinement.
void add_noise(Map& map) {
  const auto refined = [](double factor) {
    return [factor](Cell& cell) {
      cell.scene.spacing /= factor;
      set_stages(cell.scene, 300.0 * factor);
      cell.scene.stages[1].strength_reduction = 1.5;
      cell.scene.stages[1].duration = 5.0;
      cell.steps = 200000;
    };
  };
  map.axis({"noise", "slope at SRF 1.5", slope_scene, false, 0.0},
           {{"dx 1 m", refined(1), true}, {"dx 0.5 m", refined(2)}, {"dx 0.25 m", refined(4)}});
  const Build column = [](const std::string& name) {
    Scene scene = bed_scene(name, 4, 8, 0.4);
    scene.materials = {soil(10e6, 0, 30)};
    scene.walls = {wall_2d("ground", WallKind::no_slip, {line_2d(0, 0, 40, 0)}),
                   wall_2d("back", WallKind::free_slip, {line_2d(0, 20, 0, 0)})};
    scene.stages = {lasting("collapse", 5.0)};
    return scene;
  };
  const auto finer = [](double factor) {
    return [factor](Cell& cell) {
      cell.scene.spacing /= factor;
      cell.steps = 200000;
    };
  };
  map.axis({"noise", "column after its collapse", column, false, 0.0},
           {{"dx 0.4 m", finer(1), true}, {"dx 0.2 m", finer(2)}, {"dx 0.1 m", finer(4)}});
}

}  // namespace

std::vector<Cell> stability_cells(bool short_form) {
  Map map(short_form);
  add_stiffness(map);
  add_strength(map);
  add_loading(map);
  add_shape(map);
  add_scale(map);
  add_noise(map);
  return map.take();
}

}  // namespace scarp::validation
