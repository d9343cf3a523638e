// SPDX-License-Identifier: BSD-3-Clause
/// Settlement and stress of an elastic column under its own weight, against the closed form.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/output/text_file.hpp"
#include "engine/scene/facets.hpp"
#include "validation/case_list.hpp"
#include "validation/convergence.hpp"
#include "validation/extruded.hpp"

namespace scarp::validation {
namespace {

/// Confined compression of a column under its weight. The soil is hypoelastic and compressed in one
/// direction, so its strain is logarithmic: stretch exp(-gamma (H - Y)/M_oed) at the height Y it
/// started from, stress -gamma (H - Y).
struct Column {
  double unit_weight, height, modulus, poisson;

  explicit Column(const Scene& scene) {
    const Material& soil = scene.materials.front();
    const double youngs = soil.model.parameter("youngs_modulus");
    poisson = soil.model.parameter("poisson_ratio");
    unit_weight = -soil.density * scene.gravity[1];
    height = std::get<Box>(scene.bodies.front().shape).maximum[1];
    modulus = youngs * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  }
  double stress(double start) const { return -unit_weight * (height - start); }
  double settlement(double start) const {
    const double a = unit_weight / modulus;
    return start - std::exp(-a * height) * std::expm1(a * start) / a;
  }
};

struct Outcome {
  double settlement = 0.0;    ///< of the highest particle over the closed form at its own place
  double stress_error = 0.0;  ///< rms over gamma H
  double layer = 0.0;         ///< dx over H
  double k0 = 0.0;            ///< sum of horizontal over sum of vertical stress
  double poisson = 0.0;
  double lattice_moment = 0.0;
  bool at_rest = false;
};

Outcome measure(const Simulation& settled) {
  const Column column(settled.scene());
  const std::vector<double> position = settled.field("position"),
                            displacement = settled.field("displacement"),
                            stress = settled.field("stress");
  Outcome outcome;
  outcome.poisson = column.poisson;
  outcome.lattice_moment = settled.lattice_moment();
  outcome.at_rest = settled.stage_reached_rest();
  double highest = 0.0, squares = 0.0, vertical = 0.0, horizontal = 0.0;
  for (std::size_t i = 0; i < settled.soil_count(); ++i) {
    const double start = position[3 * i + 1] - displacement[3 * i + 1];
    if (start > highest) {
      highest = start;
      outcome.settlement = -displacement[3 * i + 1] / column.settlement(start);
    }
    const double error = stress[6 * i + 1] - column.stress(start);
    squares += error * error;
    vertical += stress[6 * i + 1];
    horizontal += 0.5 * (stress[6 * i] + stress[6 * i + 2]);
  }
  outcome.stress_error = std::sqrt(squares / static_cast<double>(settled.soil_count())) /
                         (column.unit_weight * column.height);
  outcome.layer = settled.scene().spacing / column.height;
  outcome.k0 = horizontal / vertical;
  return outcome;
}

/// Vertical stress of the particles of a settled column beside the closed form, as a table.
void write_profile(const CaseRun& run, const std::string& name, const Simulation& settled) {
  const Column column(settled.scene());
  const std::vector<double> position = settled.field("position"),
                            displacement = settled.field("displacement"),
                            stress = settled.field("stress");
  CsvFile table(run.folder() / ("profile_" + name + ".csv"),
                {"height [m]", "vertical_stress [Pa]", "closed_form [Pa]"});
  for (std::size_t i = 0; i < settled.soil_count(); ++i) {
    const double start = position[3 * i + 1] - displacement[3 * i + 1];
    table << start << stress[6 * i + 1] << column.stress(start);
    table.end_row();
  }
}

/// What both errors tend to on a lattice of moment m: stress 1/m, settlement 1/m^2 times the true
/// one; rms of a triangle over its height is 1/sqrt(3).
void judge(CaseRun& run, const std::string& who, bool normalised,
           const std::vector<double>& spacings, const std::vector<Outcome>& outcomes) {
  const Outcome& finest = outcomes.back();
  const double moment = normalised ? 1.0 : finest.lattice_moment;
  const double settlement = 1.0 / (moment * moment);
  const double band = normalised ? 0.01 : 0.015;
  if (!normalised) {
    run.add(reported(who + "lattice moment M", finest.lattice_moment, "",
                     "stress is 1/M, settlement 1/M^2 times the true one"));
  }
  run.add(within(who + "settlement over theory", finest.settlement, "", settlement,
                 settlement * (1.0 - band), settlement * (1.0 + band),
                 normalised ? "closed form, 1 %" : "1/M^2 times the closed form, 1.5 %"));
  const double k0 = finest.poisson / (1.0 - finest.poisson);
  // The walls are exact mirrors, so the lateral strain is zero but for round-off of some thousand
  // steps.
  run.add(within(who + "horizontal over vertical stress", finest.k0, "", k0, k0 - 1e-9, k0 + 1e-9,
                 "nu/(1 - nu); lateral strain is zero to round-off"));
  run.add(holds(
      who + "came to rest",
      std::all_of(outcomes.begin(), outcomes.end(), [](const Outcome& one) { return one.at_rest; }),
      "slower than 1e-6 m/s: 4e-6 of the weight is not yet in balance"));
  std::vector<ErrorAtSpacing> settlements, stresses;
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    settlements.push_back({spacings[k], outcomes[k].settlement - settlement});
    stresses.push_back({spacings[k], outcomes[k].stress_error});
  }
  const double lattice_error = (1.0 / moment - 1.0) / std::sqrt(3.0);
  judge_convergence(
      run, who + (normalised ? "settlement over theory - 1" : "settlement over theory - 1/M^2"),
      settlements, {settlement * band, {}, "as the settlement"});
  // Only the layers below the surface, where the smoothing is cut off, can err by a share of their
  // own weight gamma dx; a base that misjudges the weight below it errs by all of it.
  judge_convergence(
      run, who + "rms error of vertical stress over gamma H", stresses,
      {lattice_error + 0.1 * finest.layer, normalised ? std::optional(1.0) : std::nullopt,
       normalised ? "dx/(10 H), a tenth of a layer's weight; at least first order"
                  : "(1/M - 1)/sqrt(3) of the lattice and dx/(10 H)"});
}

/// The column in 3D: as wide as its images need and no wider, since nothing varies across it.
Scene square_column(Scene scene) {
  const double width = 4.0 * scene.spacing;
  std::get<Box>(scene.bodies.front().shape).maximum[0] = width;
  for (Probe& probe : scene.probes) probe.at[0] = 0.5 * width;
  for (Wall& wall : scene.walls) {
    wall.facets = box_facets({{0, 0, 0}, {width, 1.2 * Column(scene).height, 0}}, {"+y"}, 2);
  }
  return extruded(std::move(scene), width);
}

double outcome_of(CaseRun& run, const Scene& scene) {
  return measure(run.solve("column", scene)).stress_error;
}

}  // namespace

const ErrorProblem oedometer_problem{
    "rms error of vertical stress over gamma H", {1.0, 0.5, 0.25, 0.125}, outcome_of};

void oedometer(CaseRun& run) {
  const std::vector<double> spacings = run.spacings({0.5, 0.25, 0.125});
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    for (const int dimension : {2, 3}) {
      std::vector<Outcome> outcomes;
      bool normalised = false;
      for (const double spacing : spacings) {
        Scene scene = run.scene_at(spacing, preset);
        normalised = scene.numerics.lattice_normalisation;
        if (dimension == 3) scene = square_column(std::move(scene));
        last = run.solve(fmt::format("{} {}D, dx = {} m", preset, dimension, spacing), scene);
        outcomes.push_back(measure(*last));
      }
      judge(run, fmt::format("{} {}D: ", preset, dimension), normalised, spacings, outcomes);
      write_profile(run, fmt::format("{}_{}d", preset, dimension), *last);
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
