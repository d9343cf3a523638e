// SPDX-License-Identifier: BSD-3-Clause
/// Three slopes with published factors of safety, by strength reduction and by Bishop's method.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/errors.hpp"
#include "engine/fos/failure_run.hpp"
#include "validation/case_list.hpp"
#include "validation/factor_of_safety.hpp"

namespace scarp::validation {
namespace {

struct PublishedSlope {
  const char* name;
  const char* file;  ///< in the case's folder
  double lowest, highest;
  const char* source;
  bool by_slices;                ///< published by a method of slices, as Bishop's is
  std::vector<double> spacings;  ///< of the full form, coarse to fine [m]
};

const std::vector<PublishedSlope>& slopes() {
  static const std::vector<PublishedSlope> all{
      {"Arai-Tagyo 1",
       "arai_tagyo.toml",
       1.403,
       1.408,
       "Arai and Tagyo (1985), example 1, circular",
       true,
       {2.0, 1.0, 0.5}},
      {"Griffiths-Lane 1",
       "slopes_fos.toml",
       1.380,
       1.380,
       "Bishop and Morgenstern's chart, in Griffiths and Lane (1999)",
       true,
       {0.5, 0.25, 0.125}},
      {"Griffiths-Lane 6, dry dam",
       "dam.toml",
       2.4,
       2.4,
       "Griffiths and Lane (1999), finite elements",
       false,
       {2.84, 1.42, 0.71}},
  };
  return all;
}

/// Settles a scene; its cost is booked.
Simulation settled_state(CaseRun& run, const std::string& name, const Scene& scene) {
  Simulation simulation(scene, run.options().run);
  run.run_stage(name + ", settle", simulation);
  return simulation;
}

/// Bishop's factor for soil that shears at constant volume. On a band without dilation the
/// principal stresses stand at 45 degrees, so the shear stress is the radius of Mohr's circle
/// (Davis 1968); with the cone of E11 and psi = 0 that is q (c + s tan phi), q = 1/sqrt(1 + 4/3
/// tan^2 phi), phi after reduction. F = q(F) F_Bishop, since Bishop's factor scales with c and tan
/// phi together.
double constant_volume_factor(double bishop, double friction_angle) {
  double factor = bishop;
  for (int k = 0; k < 50; ++k) {
    const double tangent = std::tan(friction_angle) / factor;
    factor = bishop / std::sqrt(1.0 + 4.0 / 3.0 * tangent * tangent);
  }
  return factor;
}

FactorOfSafety search(CaseRun& run, const std::string& name, StrengthReduction& slope,
                      double bishop) {
  // Either side of where it should be; the search steps outward if it is not there.
  return search_factor(run, name, slope,
                       {0.94 * bishop, 1.06 * bishop, run.short_form() ? 0.02 : 0.01});
}

/// Every trial that was taken to stand early, once more to the end of its window.
void judge_early_stops(CaseRun& run, const std::string& name, const StrengthReduction& slope,
                       const FactorOfSafety& found) {
  Criterion whole = slope.criterion();
  whole.early_stop = false;
  StrengthReduction same(slope.settled().clone(), whole);
  int changed = 0, checked = 0;
  for (const Trial& trial : found.trials) {
    if (trial.end != TrialEnd::came_to_rest) continue;
    ++checked;
    changed += same.respond(trial.reduction, {})->fails ? 1 : 0;
  }
  run.add(within(name + ": verdicts changed by stopping early", changed, "", 0.0, 0.0, 0.0,
                 fmt::format("exact: {} trials run to the end of the window", checked)));
}

/// The same slope of another soil.
void tell_with(CaseRun& run, const std::string& name, Scene scene, const SoilModel& soil,
               double bishop) {
  scene.materials.front().model = soil;
  StrengthReduction slope(settled_state(run, name, scene), choose_criterion(scene, {}));
  const double factor = search(run, name, slope, bishop).bracket.factor().value_or(std::nan(""));
  run.add(reported(name + ": FOS", factor, "",
                   fmt::format("{:+.1f} % from Bishop", 100.0 * (factor / bishop - 1.0))));
}

/// With psi = phi the soil obeys the normality that Bishop's method and limit analysis rest on;
/// Mohr-Coulomb has Coulomb's strength without a choice of cone.
void tell_other_soils(CaseRun& run, const std::string& name, const Scene& scene, double bishop) {
  const auto cone = scene.materials.front().model.as<DruckerPrager>();
  DruckerPrager associated = cone;
  associated.dilation_angle = cone.friction_angle;
  MohrCoulomb coulomb{cone.youngs_modulus, cone.poisson_ratio, cone.cohesion, cone.friction_angle,
                      cone.dilation_angle};
  tell_with(run, name + ", psi = phi", scene, associated, bishop);
  tell_with(run, name + ", Mohr-Coulomb", scene, coulomb, bishop);
  coulomb.dilation_angle = coulomb.friction_angle;
  tell_with(run, name + ", Mohr-Coulomb, psi = phi", scene, coulomb, bishop);
}

void tell_sudden(CaseRun& run, const std::string& name, const Simulation& settled, double bishop) {
  CriterionOptions options;
  options.ramp = 0.0;
  StrengthReduction slope(settled.clone(), choose_criterion(settled.scene(), options));
  const FactorOfSafety found = search(run, name + ", at once", slope, bishop);
  run.add(reported(name + ": FOS with the strength cut at once",
                   found.bracket.factor().value_or(std::nan("")), "",
                   "inertia of the sudden cut included"));
}

/// What is judged at the finest spacing of the form, and the picture of the failure.
void judge_finest(CaseRun& run, const PublishedSlope& published, StrengthReduction& slope,
                  const FactorOfSafety& found, const BishopResult& bishop) {
  const std::string name = published.name;
  const Scene& scene = slope.settled().scene();
  const Slope ground = slope_of(scene);
  const double reference = bishop.factor_of_safety;
  judge_factor(run, fmt::format("{}: FOS at dx {:g} m", name, scene.spacing), found.bracket,
               reference,
               fmt::format("Bishop, own; {:.3g} spacings in the height",
                           slope.criterion().height / scene.spacing));
  if (published.by_slices) {
    run.add(within(name + ": FOS by Bishop", reference, "",
                   0.5 * (published.lowest + published.highest), 0.99 * published.lowest,
                   1.01 * published.highest, std::string(published.source) + "; 1 %"));
  } else {  // another method, to two digits: nothing to hold an oracle against
    run.add(reported(name + ": FOS by Bishop", reference, "",
                     fmt::format("{:g}, {}", published.lowest, published.source)));
  }
  run.add(reported(name + ": Bishop's factor for shear at constant volume",
                   constant_volume_factor(reference, ground.friction_angle), "",
                   "what psi = 0 leaves of it in a thin band"));
  const std::filesystem::path folder = run.folder() / std::filesystem::path(published.file).stem();
  run_failure(slope, found.bracket.fails.value_or(reference), folder, {});
  write_bishop(folder / "bishop.json", ground, bishop);
  write_trials(folder / "displacement_srf.csv", found);
}

/// One slope at the spacings of the form; the finest is judged.
Simulation judge_slope(CaseRun& run, const PublishedSlope& published) {
  const std::string name = published.name;
  const std::vector<double> spacings = run.spacings(published.spacings);
  std::optional<Simulation> last;
  ConvergenceSeries series{name + ": FOS over Bishop, less 1", {}, 0.0};
  for (const double spacing : spacings) {
    const Scene scene = run.scene_at(spacing, run.options().preset, published.file);
    const BishopResult bishop = bishop_search(slope_of(scene), 100);
    const double reference = bishop.factor_of_safety;
    const std::string at = fmt::format("{}, dx {:g} m", name, spacing);
    StrengthReduction slope(settled_state(run, at, scene), choose_criterion(scene, {}));
    const FactorOfSafety found = search(run, at, slope, reference);
    const double factor = found.bracket.factor().value_or(std::nan(""));
    series.errors.push_back({spacing, factor / reference - 1.0});
    if (spacing == published.spacings[1]) {
      tell_other_soils(run, name, scene, reference);
      tell_sudden(run, name, slope.settled(), reference);
    }
    if (spacing == spacings.back()) {
      judge_finest(run, published, slope, found, bishop);
      last.emplace(slope.settled().clone());
    } else {
      run.add(reported(
          fmt::format("{}: FOS at dx {:g} m", name, spacing), factor, "",
          fmt::format("{:.3g} spacings in the height", slope.criterion().height / spacing)));
    }
    if (spacing == spacings.front() && spacings.size() > 1) {
      judge_early_stops(run, name, slope, found);
    }
  }
  series.order = observed_order(series.errors);
  if (series.errors.size() > 1) run.add(series);
  return std::move(*last);
}

}  // namespace

void slopes_fos(CaseRun& run) {
  std::optional<Simulation> last;
  const std::size_t count = run.short_form() ? 1 : slopes().size();
  for (std::size_t s = 0; s < count; ++s) last.emplace(judge_slope(run, slopes()[s]));
  run.finish(&*last);
}

}  // namespace scarp::validation
