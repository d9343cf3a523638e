// SPDX-License-Identifier: BSD-3-Clause
/// Displacement and factor of safety of a standing slope, turned against the lattice.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "validation/cases/askew/parts.hpp"
#include "validation/cases/askew/turned.hpp"
#include "validation/factor_of_safety.hpp"

namespace scarp::validation {
namespace {

/// The slope of the case slope_2d, settled, and its strength then cut.
Scene slope_scene(const CaseRun& run, const std::string& preset, double spacing, double angle) {
  Scene scene = turned(run.scene_at(spacing, preset, "../slope_2d/slope_2d.toml"), angle);
  scene.output.energy = false;
  return scene;
}

struct Standing {
  double largest = 0.0, crest = 0.0;  ///< displacement [m]
  double inside = 0.0;                ///< the largest five spacings and more from the walls [m]
  bool at_rest = false;
};

Standing standing_slope(CaseRun& run, const std::string& name, Scene scene, double degrees,
                        double reduction, std::optional<Simulation>& last) {
  Stage& cut = scene.stages.back();
  cut.strength_reduction = reduction;
  cut.rest_velocity = 1e-4;  // as in the scalar error of slope_2d
  cut.damping = damping_of(scene, 15.0);
  cut.duration = 4.0;
  last = run.solve(name, scene);
  Standing standing;
  standing.at_rest = last->stage_reached_rest();
  const Vec3 u = last->probe("crest").displacement;
  standing.crest = std::hypot(u[0], u[1]);
  const double margin = 5.0 * scene.spacing;
  for (const TurnedBack& one : turned_back(*last, radians(degrees))) {
    const double way = std::hypot(one.displacement[0], one.displacement[1]);
    standing.largest = std::fmax(standing.largest, way);
    if (std::min({one.start[0], 45.0 - one.start[0], one.start[1]}) > margin)
      standing.inside = std::fmax(standing.inside, way);
  }
  return standing;
}

}  // namespace

void judge_slope(CaseRun& run, const std::string& preset, double spacing,
                 const std::vector<double>& angles, std::optional<Simulation>& last) {
  // 5 % at the main spacing, in proportion at others: the outline is known to half a spacing.
  const double band = 0.05 * spacing / 0.25;
  for (const double reduction : {1.1, 1.2}) {
    std::optional<Standing> aligned;
    for (const double degrees : angles) {
      const std::string who =
          fmt::format("{}, slope at SRF {}, dx = {} m, turned by {} deg: ", preset, reduction,
                      spacing, degrees);
      const Standing one = standing_slope(
          run, who, slope_scene(run, preset, spacing, radians(degrees)), degrees, reduction, last);
      run.add(holds(who + "stands", one.at_rest, "slower than 0.1 mm/s within 4 s"));
      run.add(reported(who + "largest displacement", one.largest, "m"));
      run.add(reported(who + "displacement of the crest", one.crest, "m"));
      if (!aligned) {
        aligned = one;
        continue;
      }
      run.add(within(who + "largest displacement over the aligned one",
                     one.largest / aligned->largest, "", 1.0, 1.0 - band, 1.0 + band,
                     "5 % at 0.25 m, in proportion to the spacing"));
      run.add(reported(who + "the same five spacings and more from the walls",
                       one.inside / aligned->inside, ""));
      run.add(reported(who + "displacement of the crest over the aligned one",
                       one.crest / aligned->crest, ""));
    }
  }
}

/// Both factors lie within half a tolerance of the middle of their brackets.
void judge_factors(CaseRun& run, const std::string& preset, double spacing,
                   const std::vector<double>& angles) {
  constexpr double tolerance = 0.02;
  std::optional<double> aligned;
  for (const double degrees : angles) {
    const std::string who =
        fmt::format("{}, slope, dx = {} m, turned by {} deg", preset, spacing, degrees);
    Simulation simulation(slope_scene(run, preset, spacing, radians(degrees)), run.options().run);
    run.run_stage(who + ", settle", simulation);
    StrengthReduction slope(simulation.clone(), choose_criterion(simulation.scene(), {}));
    const double factor = search_factor(run, who, slope, {1.3, 1.45, tolerance})
                              .bracket.factor()
                              .value_or(std::nan(""));
    if (!aligned) aligned = factor;
    if (degrees == 0.0) {
      run.add(reported(who + ": factor of safety", factor, ""));
    } else {
      run.add(within(who + ": factor of safety over the aligned one", factor / *aligned, "", 1.0,
                     1.0 - tolerance, 1.0 + tolerance, "tolerance of the search"));
    }
  }
}

}  // namespace scarp::validation
