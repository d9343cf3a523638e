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
  const double kinetic = simulation->energy().kinetic, end = scene.stages.front().duration.value();
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

void report(CaseRun& run, const std::string& who, const Outcome& outcome) {
  const std::string fate =
      outcome.collapsed ? "the time step collapsed"
      : outcome.fractured()
          ? fmt::format("of half the thickness; broken, ended at {:.2g} ms", 1e3 * outcome.end)
          : "of half the thickness; whole";
  run.add(reported(who + ": cracks", outcome.cracks, "", fate));
}

/// The recommended setting must hold, and must be needed.
void judge(CaseRun& run, const std::string& who, const Outcome& recommended,
           const Outcome& without) {
  run.add(within(who + "cracks in the recommended setting", recommended.cracks, "", 0.0, 0.0, 1.0,
                 "new surface below one crack through half a ring"));
  run.add(within(who + "speed apart over speed of approach", recommended.restitution, "", {}, 0.0,
                 1.0, "the rings bounce; 1 without losses and without vibration"));
  run.add(reported(who + "kinetic energy after over before", recommended.kinetic, ""));
  run.add(reported(who + "elastic energy after over kinetic before", recommended.elastic, "",
                   "the rings go on vibrating"));
  run.add(reported(who + "taken by viscosity", recommended.viscous, ""));
  run.add(reported(who + "taken by artificial stress", recommended.tension, ""));
  run.add(holds(who + "fracture without artificial stress", without.fractured(),
                "else the case could not tell a setting that holds"));
}

Scene with(Scene scene, const Setting& one) {
  scene.numerics.smoothing = one.smoothing;
  scene.numerics.smoothing_ratio = one.ratio;
  scene.numerics.artificial_stress = one.artificial_stress;
  return scene;
}

/// The others, for a person who chooses.
void compare(CaseRun& run, double spacing) {
  for (const double epsilon : {0.5, 0.3, 0.0}) {
    for (const Setting& one : {setting(SmoothingFunction::wendland_c2, 1.5, epsilon),
                               setting(SmoothingFunction::cubic_spline, 1.2, epsilon),
                               setting(SmoothingFunction::yang_liu, 1.2, epsilon)}) {
      // With the Wendland function 0.5 and 0 are judged apart.
      if (one.smoothing == SmoothingFunction::wendland_c2 && epsilon != 0.3) continue;
      const std::string who = fmt::format("modern, {}, dx = {} m", one.name, spacing);
      std::optional<Simulation> ended;
      report(run, who, bounce(run, who, with(run.scene_at(spacing, "modern"), one), ended));
    }
  }
}

}  // namespace

void rings(CaseRun& run) {
  const std::vector<double> spacings = run.spacings({0.001, 0.0005, 0.00025});
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    if (preset == "paper") {
      const std::string who = fmt::format("paper, Yang & Liu 1.2, eps 0.3, dx = {} m", spacings[0]);
      Scene scene =
          with(run.scene_at(spacings[0], preset), setting(SmoothingFunction::yang_liu, 1.2, 0.3));
      scene.numerics.viscosity_alpha = 0.1;
      report(run, who, bounce(run, who, scene, last));
      continue;
    }
    for (const double spacing : spacings) {
      const Scene scene = run.scene_at(spacing, preset);
      Scene without = scene;
      without.numerics.artificial_stress = 0.0;
      const std::string who = fmt::format("modern, dx = {} m: ", spacing);
      const Outcome broken = bounce(run, who + "eps 0", without, last);
      write_snapshot(run.folder() / "broken.csv", *last);
      const Outcome whole = bounce(run, who + "recommended", scene, last);
      write_snapshot(run.folder() / "whole.csv", *last);
      judge(run, who, whole, broken);
      if (!run.short_form() && spacing > 0.0004) compare(run, spacing);
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
