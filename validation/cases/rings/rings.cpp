// SPDX-License-Identifier: BSD-3-Clause
/// Two rubber rings that bounce: which settings keep them whole.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "validation/case_list.hpp"
#include "validation/cases/rings/new_surface.hpp"

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
  double cracks = 0.0;       ///< most new surface at any time, in cracks halfway through a ring
  double restitution = 0.0;  ///< speed apart over speed of approach of the rings' centres
  double kinetic = 0.0, elastic = 0.0, viscous = 0.0, tension = 0.0;  ///< over the start
  double end = 0.0;                                                   ///< when the run ended [s]
  bool collapsed = false;  ///< a value was not finite, or the time step fell to a twentieth
  bool fractured() const { return collapsed || cracks >= 1.0; }
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

/// Runs until the rings have parted, or until fracture is certain: cracks do not heal.
Outcome bounce(CaseRun& run, const std::string& name, const Scene& scene,
               std::optional<Simulation>& simulation) {
  constexpr double certain = 4.0;  // cracks
  simulation.emplace(scene, run.options().run);
  const NewSurface surface(*simulation);
  const std::array<double, 2> before = ring_speeds(*simulation);
  const double kinetic = simulation->energy().kinetic, end = scene.stages.front().duration;
  const Cylinder& ring = std::get<Cylinder>(scene.bodies.front().shape);
  // Two faces, each half as long as the ring is thick.
  const double crack = (ring.radius - ring.inner_radius) / scene.spacing;
  Outcome outcome;
  double next = 0.0, first_step = 0.0;
  try {
    run.run_stage(name, *simulation, nullptr, [&](const Simulation& now) {
      // Grains shot out at many times the speed of sound: the step falls and the run would not end.
      if (first_step == 0.0) first_step = now.last_step().time_step;
      outcome.collapsed = now.last_step().time_step < 0.05 * first_step && !now.stage_ended();
      if (now.last_step().time >= next) {
        next += 0.02 * end;
        outcome.cracks = std::fmax(outcome.cracks, static_cast<double>(surface.count(now)) / crack);
      }
      if (outcome.collapsed || outcome.cracks > certain) simulation->end_stage();
    });
  } catch (const SimulationInstability&) {
    outcome.collapsed = true;
  }
  const std::array<double, 2> after = ring_speeds(*simulation);
  const EnergyBalance energy = simulation->energy();
  outcome.end = simulation->last_step().time;
  outcome.restitution = (after[1] - after[0]) / (before[0] - before[1]);
  outcome.kinetic = energy.kinetic / kinetic;
  outcome.elastic = energy.elastic / kinetic;
  outcome.viscous = energy.viscous / kinetic;
  outcome.tension = energy.artificial_stress / kinetic;
  return outcome;
}

}  // namespace

void rings(CaseRun& run) {
  std::optional<Simulation> last;
  for (const double spacing : run.spacings({0.001, 0.0005, 0.00025})) {
    std::vector<Setting> tried;
    for (const double epsilon : {0.5, 0.3, 0.0}) {
      tried.push_back(setting(SmoothingFunction::wendland_c2, 1.5, epsilon));
      tried.push_back(setting(SmoothingFunction::cubic_spline, 1.2, epsilon));
      tried.push_back(setting(SmoothingFunction::yang_liu, 1.2, epsilon));
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
        fmt::print(
            "{:<45} cracks {:.3f} e {:.3f} KE {:.3f} el {:.3f} visc {:.3f} tens {:.3f} end {:.3g} "
            "{}\n",
            who, o.cracks, o.restitution, o.kinetic, o.elastic, o.viscous, o.tension, o.end,
            o.collapsed);
        std::fflush(stdout);
        write_snapshot(run.folder() / fmt::format("s{}.csv", k++), *last);
      }
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
