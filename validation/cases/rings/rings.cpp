// SPDX-License-Identifier: BSD-3-Clause
/// Two rubber rings that bounce: which settings keep them whole.

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "validation/case_list.hpp"
#include "validation/cases/rings/bonds.hpp"

namespace scarp::validation {
namespace {

struct Setting {
  SmoothingFunction smoothing;
  double ratio;              ///< h/dx
  double artificial_stress;  ///< epsilon
  std::string name;
};

Setting setting(SmoothingFunction smoothing, double ratio, double epsilon) {
  const char* names[] = {"Yang & Liu", "cubic spline", "Wendland C2"};
  return {smoothing, ratio, epsilon,
          fmt::format("{} {}, eps {}", names[static_cast<int>(smoothing)], ratio, epsilon)};
}

struct Outcome {
  double longest_bond = 1.0;   ///< over the spacing, in the whole run
  double broken_bonds = 0.0;   ///< share longer than `broken_length` at the end
  int fragments = 0;           ///< pieces beyond the two rings
  double restitution = 0.0;    ///< speed apart over speed of approach of the rings' centres
  double kinetic = 0.0;        ///< at the end, over the start
  double dissipated = 0.0;     ///< viscosity, artificial stress and residue over the start
  double imbalance = 0.0;      ///< over the start
  double fracture_time = 0.0;  ///< first broken bond [s]; NaN: none
  bool unstable = false;       ///< a value was not finite, or the time step collapsed
  bool fractured() const { return unstable || broken_bonds > 0.0 || std::isfinite(fracture_time); }
};

/// Mean velocity along x of the rings at left and right.
std::array<double, 2> ring_speeds(const Simulation& simulation) {
  const std::vector<double> velocity = simulation.field("velocity");
  std::array<double, 2> sum{};
  const std::size_t half = simulation.soil_count() / 2;  // equal rings, one body after the other
  for (std::size_t i = 0; i < simulation.soil_count(); ++i) sum[i >= half] += velocity[3 * i];
  return {sum[0] / static_cast<double>(half), sum[1] / static_cast<double>(half)};
}

/// Places and mean stress, for the figure.
void write_snapshot(const std::filesystem::path& path, const Simulation& simulation) {
  CsvFile table(path, {"x [m]", "y [m]", "mean stress [Pa]"});
  const std::vector<double> position = simulation.field("position"),
                            stress = simulation.field("stress");
  for (std::size_t i = 0; i < simulation.soil_count(); ++i) {
    table << position[3 * i] << position[3 * i + 1]
          << (stress[6 * i] + stress[6 * i + 1] + stress[6 * i + 2]) / 3.0;
    table.end_row();
  }
}

/// Runs until the rings have parted, or until fracture is certain: bonds do not heal.
Outcome bounce(CaseRun& run, const std::string& name, const Scene& scene,
               std::optional<Simulation>& simulation) {
  constexpr double certain = 0.01;  // share of broken bonds
  simulation.emplace(scene, run.options().run);
  const Bonds bonds(*simulation);
  const std::array<double, 2> before = ring_speeds(*simulation);
  const double kinetic = simulation->energy().kinetic, end = scene.stages.front().duration;
  Outcome outcome;
  outcome.fracture_time = std::numeric_limits<double>::quiet_NaN();
  double next = 0.0, first_step = 0.0;
  try {
    run.run_stage(name, *simulation, nullptr, [&](const Simulation& now) {
      // Grains shot out at many times the speed of sound: the step falls and the run would not end.
      if (first_step == 0.0) first_step = now.last_step().time_step;
      if (now.last_step().time_step < 0.05 * first_step) {
        outcome.unstable = true;
        simulation->end_stage();
      }
      if (now.last_step().time < next) return;
      next += 0.005 * end;
      const double longest = bonds.longest(now);
      outcome.longest_bond = std::fmax(outcome.longest_bond, longest);
      if (longest > Bonds::broken_length && !std::isfinite(outcome.fracture_time))
        outcome.fracture_time = now.last_step().time;
      if (bonds.broken_share(now) > certain) simulation->end_stage();
    });
  } catch (const SimulationInstability&) {
    outcome.unstable = true;
  }
  const std::array<double, 2> after = ring_speeds(*simulation);
  const EnergyBalance energy = simulation->energy();
  outcome.broken_bonds = bonds.broken_share(*simulation);
  outcome.fragments = bonds.pieces(*simulation) - 2;
  outcome.restitution = (after[1] - after[0]) / (before[0] - before[1]);
  outcome.kinetic = energy.kinetic / kinetic;
  outcome.dissipated =
      (energy.viscous + energy.artificial_stress + energy.gradient_residue + energy.diffusion) /
      kinetic;
  outcome.imbalance = energy.imbalance / kinetic;
  return outcome;
}

void report(CaseRun& run, const std::string& who, const Outcome& outcome) {
  run.add(reported(who + "longest bond over dx", outcome.longest_bond, "", "in the whole run"));
  run.add(reported(who + "share of broken bonds", outcome.broken_bonds, "",
                   outcome.unstable      ? "the time step collapsed"
                   : outcome.fractured() ? fmt::format("first at {:.3g} ms, run ended at 1 %",
                                                       1e3 * outcome.fracture_time)
                                         : "none"));
}

}  // namespace

void rings(CaseRun& run) {
  std::optional<Simulation> last;
  for (const double spacing : run.spacings({0.001, 0.0005, 0.00025})) {
    std::vector<Setting> tried;
    for (const double epsilon : {0.0, 0.3, 0.5}) {
      tried.push_back(setting(SmoothingFunction::cubic_spline, 1.5, epsilon));
      tried.push_back(setting(SmoothingFunction::cubic_spline, 1.2, epsilon));
      tried.push_back(setting(SmoothingFunction::wendland_c2, 1.5, epsilon));
      tried.push_back(setting(SmoothingFunction::yang_liu, 1.2, epsilon));
      tried.push_back(setting(SmoothingFunction::yang_liu, 1.5, epsilon));
    }
    int k = 0;
    for (const std::string& preset : run.presets()) {
      for (const Setting& one : tried) {
        Scene scene = run.scene_at(spacing, preset);
        scene.numerics.smoothing = one.smoothing;
        scene.numerics.smoothing_ratio = one.ratio;
        scene.numerics.artificial_stress = one.artificial_stress;
        const std::string who = fmt::format("{}, {}, dx = {} m", preset, one.name, spacing);
        const Outcome o = bounce(run, who, scene, last);
        report(run, who + ": ", o);
        fmt::print(
            "{:<45} bond {:.3f} broken {:.4f} frag {} e {:.3f} KE {:.3f} diss {:.3f} imb {:.4f} t "
            "{:.3g}  {}\n",
            who, o.longest_bond, o.broken_bonds, o.fragments, o.restitution, o.kinetic,
            o.dissipated, o.imbalance, o.fracture_time, o.unstable);
        std::fflush(stdout);
        write_snapshot(run.folder() / fmt::format("s{}.csv", k++), *last);
      }
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
