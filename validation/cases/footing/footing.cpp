// SPDX-License-Identifier: BSD-3-Clause
/// Bearing capacity of a strip footing against Prandtl.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "engine/output/text_file.hpp"
#include "validation/case_list.hpp"
#include "validation/convergence.hpp"

namespace scarp::validation {
namespace {

constexpr double width = 2.0;  ///< B of the whole footing [m]
/// Settlement over B at which the pressure is judged: past five times the elastic settlement, small
/// beside a spacing. The push of the main form goes on to twice as far.
constexpr double judged_from = 0.004, judged_to = 0.005;

/// Prandtl's N_c = (N_q - 1)/tan phi, N_q = exp(pi tan phi) tan^2(45 + phi/2); 2 + pi for phi = 0.
double bearing_capacity_factor(double friction_angle) {
  if (friction_angle == 0.0) return 2.0 + std::numbers::pi;
  const double tangent = std::tan(friction_angle);
  const double passive = std::tan(0.25 * std::numbers::pi + 0.5 * friction_angle);
  return (std::exp(std::numbers::pi * tangent) * passive * passive - 1.0) / tangent;
}

/// The scene for a friction angle [degrees], psi = phi. With friction the mechanism reaches out to
/// 3.0 B from the middle, so that the soil is 4 B by 2 B instead of 2.5 B by 1.5 B.
Scene footing_scene(Scene scene, double friction_degrees) {
  const double friction = friction_degrees * std::numbers::pi / 180.0;
  scene.materials.front().model.set("friction_angle", friction);
  scene.materials.front().model.set("dilation_angle", friction);
  if (friction == 0.0) return scene;
  Box& soil = std::get<Box>(scene.bodies.front().shape);
  const double rise = 4.0 - soil.maximum[1];
  soil.maximum = {8.0, 4.0, 0.0};
  for (Wall& wall : scene.walls) {
    for (Facet& facet : wall.facets) {
      const bool upright = std::fabs(facet.normal[0]) > 0.5;
      if (wall.name == "footing") facet.origin[1] += rise;
      if (upright) facet.length_u += rise;
      if (wall.name == "symmetry") facet.origin[1] += rise;
      if (wall.name == "far" && upright) facet.origin[0] = soil.maximum[0];
      if (wall.name == "far" && !upright) facet.length_u = soil.maximum[0];
    }
  }
  return scene;
}

/// The same strength without the choice of a cone.
Scene with_coulomb(Scene scene) {
  SoilModel& soil = scene.materials.front().model;
  const auto cone = soil.as<DruckerPrager>();
  soil = MohrCoulomb{cone.youngs_modulus, cone.poisson_ratio, cone.cohesion, cone.friction_angle,
                     cone.dilation_angle};
  return scene;
}

struct Outcome {
  double ratio = 0.0;          ///< pressure under the footing over Prandtl's where it is judged
  double drift = 0.0;          ///< change of it from a settlement just as long before
  double late = std::nan("");  ///< the same at the end of a push twice as far
};

/// Mean of what is sampled between two settlements.
struct Mean {
  double from, to, sum = 0.0;
  int count = 0;

  void add(double settlement, double value) {
    if (settlement < from || settlement >= to) return;
    sum += value;
    ++count;
  }
  double value() const { return sum / count; }
};

/// Pressure under the footing as it sinks, also as a table.
Outcome press(CaseRun& run, const std::string& name, const Scene& scene,
              std::optional<Simulation>& last) {
  const kernels::CoulombStrength soil = *scene.materials.front().model.strength();
  const double capacity = soil.cohesion * bearing_capacity_factor(soil.friction_angle);
  const double speed = std::fabs(scene.walls.back().velocity[1]);
  // The push rings with a period of about that length: a shorter window would see the ringing.
  Mean before{2.0 * judged_from - judged_to, judged_from}, level{judged_from, judged_to};
  Mean late{2.0 * judged_from, 2.0 * judged_to};
  CsvFile table(run.folder() / (name + ".csv"),
                {"settlement over B [-]", "pressure over Prandtl's [-]"});
  double next = 0.0;
  last = run.solve(name, scene, [&](const Simulation& now) {
    const double settlement = speed * now.last_step().time / width;
    if (settlement < next) return;
    next += judged_to / 100.0;
    const double ratio = now.wall_reactions().back().force[1] / (0.5 * width) / capacity;
    table << settlement << ratio;
    table.end_row();
    for (Mean* mean : {&before, &level, &late}) mean->add(settlement, ratio);
  });
  return {level.value(), level.value() / before.value() - 1.0,
          late.count > 0 ? late.value() : std::nan("")};
}

/// A footing that stops where it has been judged.
Scene briefly(Scene scene) {
  scene.stages.front().duration = judged_to * width / std::fabs(scene.walls.back().velocity[1]);
  return scene;
}

double outcome_of(CaseRun& run, const Scene& scene) {
  std::optional<Simulation> last;
  return std::fabs(press(run, "push", briefly(footing_scene(scene, 0.0)), last).ratio - 1.0);
}

/// Uniform stress on a lattice of moment m exerts m times its force, so that much of Prandtl's
/// pressure is what soil at its true strength can carry there.
void judge(CaseRun& run, const std::string& who, double moment,
           const std::vector<ErrorAtSpacing>& errors, const Outcome& finest) {
  run.add(within(who + "pressure over Prandtl's", finest.ratio, "", moment, 0.97 * moment,
                 1.10 * moment,
                 moment == 1.0 ? "N_c c at 0.4 to 0.5 % of B; +10/-3 %"
                               : "M N_c c at 0.4 to 0.5 % of B; +10/-3 %"));
  run.add(within(who + "change of the pressure over 0.1 % of B", finest.drift, "", 0.0, -0.01, 0.01,
                 "a plateau: elastic loading would add 20 %"));
  if (!std::isnan(finest.late)) {
    run.add(reported(who + "pressure over Prandtl's at 0.8 to 1 % of B", finest.late, "",
                     "beyond the small displacements of the theory"));
  }
  for (const ErrorAtSpacing& one : errors) {
    run.add(reported(fmt::format("{}pressure over Prandtl's - 1, dx = {:.3g} m", who, one.spacing),
                     one.error, ""));
  }
  const double order = observed_order(errors);
  if (errors.size() > 1) run.add(reported(who + "observed order", order, ""));
  run.add(ConvergenceSeries{who + "pressure over Prandtl's - 1", errors, order});
}

/// One preset, friction angle and model at the spacings of the form; Mohr-Coulomb's push is brief.
void judge_soil(CaseRun& run, const std::string& preset, double degrees, bool coulomb,
                std::optional<Simulation>& last) {
  const char* const model = coulomb ? ", Mohr-Coulomb" : "";
  const std::string who = fmt::format("{}{}, phi = {} deg: ", preset, model, degrees);
  std::vector<ErrorAtSpacing> errors;
  Outcome finest;
  double moment = 1.0;
  for (const double spacing : run.spacings({0.1, 0.04, 1.0 / 30.0})) {
    Scene scene = footing_scene(run.scene_at(spacing, preset), degrees);
    if (coulomb) scene = with_coulomb(std::move(scene));
    if (coulomb || run.short_form()) scene = briefly(std::move(scene));
    const std::string name = fmt::format("{}{}_phi_{}_dx_{:.3g}", preset,
                                         coulomb ? "_mohr_coulomb" : "", degrees, spacing);
    finest = press(run, name, scene, last);
    errors.push_back({spacing, finest.ratio - 1.0});
    if (!scene.numerics.lattice_normalisation) moment = last->lattice_moment();
  }
  judge(run, who, moment, errors, finest);
}

}  // namespace

const ErrorProblem footing_problem{
    "bearing pressure over Prandtl's, phi = 0, less 1", {0.2, 0.1, 0.05, 0.025}, outcome_of};

void footing(CaseRun& run) {
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    for (const double degrees : {0.0, 20.0}) {
      if (degrees > 0.0 && run.short_form()) continue;
      judge_soil(run, preset, degrees, false, last);
      if (preset == "modern") judge_soil(run, preset, degrees, true, last);
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
