// SPDX-License-Identifier: BSD-3-Clause
/// Walls, slopes and gravity turned against the lattice: what soil at rest, a tilted layer and a
/// standing slope change by it.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "validation/case_list.hpp"
#include "validation/cases/askew/parts.hpp"
#include "validation/cases/askew/turned.hpp"

namespace scarp::validation {

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

double damping_of(const Scene& scene, double height) {
  return 0.5 * std::numbers::pi * scene.materials.front().sound_speed() / height;
}

void judge_in_long_forms(CaseRun& run, Measure measure) {
  run.add(run.short_form() ? reported(measure.name, measure.value, measure.unit, measure.source)
                           : std::move(measure));
}

namespace {

/// The soil of the block: its outline is a rectangle from the origin.
struct Block {
  double unit_weight, width, height, k0;

  explicit Block(const Scene& scene) {
    const Material& soil = scene.materials.front();
    const auto& outline = std::get<Polygon>(scene.bodies.front().shape).points;
    const double poisson = soil.model.parameter("poisson_ratio");
    unit_weight = soil.density * std::hypot(scene.gravity[0], scene.gravity[1]);
    width = std::hypot(outline[1][0] - outline[0][0], outline[1][1] - outline[0][1]);
    height = std::hypot(outline[3][0] - outline[0][0], outline[3][1] - outline[0][1]);
    k0 = poisson / (1.0 - poisson);
  }
};

/// Of stresses at rest against gamma z, K0 gamma z and zero; rms over gamma H.
struct StressAtRest {
  double vertical = 0.0, horizontal = 0.0, shear = 0.0;
  double inside = 0.0;  ///< vertical, five spacings and more from walls and surface
  double k0 = 0.0;      ///< sum of horizontal over sum of vertical stress
};

StressAtRest stress_at_rest(const Simulation& simulation, double angle, double moment) {
  const Block block(simulation.scene());
  StressAtRest at;
  double horizontal = 0.0, vertical = 0.0, count = 0.0, inner = 0.0;
  const double margin = 5.0 * simulation.scene().spacing;
  for (const TurnedBack& one : turned_back(simulation, angle)) {
    const double exact = -block.unit_weight * (block.height - one.start[1]) / moment;
    at.vertical += std::pow(one.yy - exact, 2);
    at.horizontal += std::pow(one.xx - block.k0 * exact, 2);
    at.shear += one.xy * one.xy;
    horizontal += one.xx;
    vertical += one.yy;
    count += 1.0;
    const double away = std::min(
        {one.start[0], block.width - one.start[0], one.start[1], block.height - one.start[1]});
    if (away < margin) continue;
    at.inside += std::pow(one.yy - exact, 2);
    inner += 1.0;
  }
  at.inside = std::sqrt(at.inside / inner) / (block.unit_weight * block.height);
  for (double* sum : {&at.vertical, &at.horizontal, &at.shear})
    *sum = std::sqrt(*sum / count) / (block.unit_weight * block.height);
  at.k0 = horizontal / vertical;
  return at;
}

/// Force on all walls, along gravity and across it, over the weight.
Vec3 reactions_over_weight(const Simulation& simulation, double angle) {
  const Vec3& g = simulation.scene().gravity;
  Vec3 sum{};
  for (const WallReaction& one : simulation.wall_reactions())
    for (std::size_t a = 0; a < 3; ++a) sum[a] += one.force[a];
  const double weight = simulation.soil_mass() * std::hypot(g[0], g[1]);
  const Vec3 own = turned_back(sum, angle);
  return {own[0] / weight, -own[1] / weight, 0.0};
}

void judge_block(CaseRun& run, const std::string& preset, double spacing, double degrees,
                 std::optional<Simulation>& last) {
  const double angle = radians(degrees);
  const std::string who =
      fmt::format("{}, at rest, dx = {} m, turned by {} deg: ", preset, spacing, degrees);
  const Scene scene = turned(run.scene_at(spacing, preset), angle);
  const Block block(scene);
  last.emplace(scene, run.options().run);
  run.run_stage(who + "settle", *last);
  const bool settled = last->stage_reached_rest();
  const Vec3 force = reactions_over_weight(*last, angle);
  const double moment = scene.numerics.lattice_normalisation ? 1.0 : last->lattice_moment();
  const StressAtRest at = stress_at_rest(*last, angle, moment);
  double fastest = 0.0;
  const double half = 0.5 * scene.stages[1].duration.value();
  run.run_stage(who + "stand", *last, nullptr, [&](const Simulation& now) {
    if (now.last_step().stage_time > half)
      fastest = std::fmax(fastest, now.last_step().max_velocity);
  });
  double drift = 0.0;
  for (const TurnedBack& one : turned_back(*last, angle))
    drift = std::fmax(drift, std::hypot(one.displacement[0], one.displacement[1]));

  // At rest every grain is slower than v, so that damping carries at most c v/g of the weight; as
  // much again for what accelerates.
  const double open = 2.0 * damping_of(scene, block.height) * scene.stages[0].rest_velocity /
                      std::hypot(scene.gravity[0], scene.gravity[1]);
  const std::string equilibrium = "equilibrium; damping and inertia of soil at rest";
  const double outline = 0.5 * spacing / block.height;
  run.add(holds(who + "came to rest", settled, "slower than 1e-5 m/s"));
  run.add(within(who + "force on the walls along gravity over the weight", force[1], "", 1.0,
                 1.0 - open, 1.0 + open, equilibrium));
  run.add(within(who + "force on the walls across gravity over the weight", force[0], "", 0.0,
                 -open, open, equilibrium));
  const std::string step = "over gamma H; the outline is known to half a spacing, dx/(2 H)";
  const auto add = [&](const std::string& name, double error) {
    run.add(within(who + name, error, "", 0.0, 0.0, outline, step));
  };
  add("rms error of the vertical stress", at.vertical);
  add("rms error of the horizontal stress", at.horizontal);
  add("rms shear stress", at.shear);
  run.add(reported(who + "rms error of the vertical stress inside", at.inside, "",
                   "five spacings and more from walls and surface"));
  run.add(within(who + "horizontal over vertical stress, over K0", at.k0 / block.k0, "", 1.0, 0.98,
                 1.02, "nu/(1 - nu), 2 % as in the case rest"));
  run.add(within(who + "fastest particle without damping", fastest, "m/s", 0.0, 0.0, 1e-3,
                 "1 mm/s: what counts as rest"));
  run.add(within(who + "way of any particle in a second without damping", drift, "m", 0.0, 0.0,
                 1e-3, "1 mm/s"));
  run.add(
      reported(who + "mass of the particles over that of the outline",
               last->soil_mass() / (scene.materials.front().density * block.width * block.height),
               "", "a particle is where the centre of its cell is in the outline"));
}

double outcome_of(CaseRun& run, const Scene& scene) {
  const double angle = radians(30.0);
  Simulation simulation(turned(scene, angle), run.options().run);
  run.run_stage("settle", simulation);
  const double moment = scene.numerics.lattice_normalisation ? 1.0 : simulation.lattice_moment();
  return stress_at_rest(simulation, angle, moment).vertical;
}

}  // namespace

const ErrorProblem askew_problem{
    "rms error of vertical stress over gamma H at rest, turned by 30 deg",
    {0.2, 0.1, 0.05, 0.025},
    outcome_of};

void askew(CaseRun& run) {
  const std::vector<double> angles = run.short_form() ? std::vector<double>{0.0, 30.0}
                                                      : std::vector<double>{0.0, 15.0, 30.0, 45.0};
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    if (preset == "paper" && run.short_form()) continue;  // its steps are short, its runs long
    for (const double spacing : run.spacings({0.1, 0.05, 0.025})) {
      if (preset == "paper" && spacing < 0.1) continue;
      for (const double degrees : angles) judge_block(run, preset, spacing, degrees, last);
    }
    if (preset == "paper") continue;
    for (const double degrees : angles) judge_layer(run, preset, 0.1, degrees, last);
    if (run.short_form()) {
      judge_slope(run, preset, 0.5, angles, last);
      continue;
    }
    judge_slope(run, preset, 0.25, angles, last);
    judge_factors(run, preset, 0.5, angles);
  }
  run.finish(last ? &*last : nullptr);
}

}  // namespace scarp::validation
