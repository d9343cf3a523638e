// SPDX-License-Identifier: BSD-3-Clause
/// Bending of elastic beams with free faces: frequency, deflection, energy, and what each setting
/// makes of them.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/scene/facets.hpp"
#include "validation/case_list.hpp"
#include "validation/cases/beam/swing.hpp"
#include "validation/convergence.hpp"

namespace scarp::validation {
namespace {

constexpr double judged_spacing = 0.1;  ///< ten spacings in the depth [m]

/// What `strip.py` finds for the frequency of an endless beam from the particle equations of
/// `modern` alone, over the exact one.
struct OfEquations {
  double spacing, frequency;
};
constexpr std::array of_equations{OfEquations{0.2, 0.8773}, OfEquations{0.1, 0.9661},
                                  OfEquations{0.05, 0.9910}};

struct Setting {
  std::string name, preset;
  void (*apply)(Numerics&);
};

void smooth(Numerics& numerics, SmoothingFunction function, double ratio) {
  numerics.smoothing = function;
  numerics.smoothing_ratio = ratio;
}

/// What THEORY.md section 7 says of elastic bodies in tension.
const Setting for_tension{"Wendland 1.5, hourglass 0.5", "modern", [](Numerics& n) {
                            smooth(n, SmoothingFunction::wendland_c2, 1.5);
                            n.hourglass_viscosity = 0.5;
                          }};
const Setting as_it_stands{"modern", "modern", [](Numerics&) {}};

/// Small deflection, with and without viscosity.
const std::vector<Setting>& other_settings() {
  static const std::vector<Setting> all{
      {"modern with the plain force", "modern", [](Numerics& n) { n.force_correction = false; }},
      {"Wendland 1.5, eps 0.5", "modern",
       [](Numerics& n) {
         smooth(n, SmoothingFunction::wendland_c2, 1.5);
         n.artificial_stress = 0.5;
       }},
      {"paper", "paper", [](Numerics&) {}},
      {"paper without artificial stress", "paper", [](Numerics& n) { n.artificial_stress = 0.0; }},
  };
  return all;
}

/// What may hold where tension is large.
const std::vector<Setting>& settings_for_tension() {
  static const std::vector<Setting> all{
      as_it_stands,
      {"modern, hourglass 0.5", "modern", [](Numerics& n) { n.hourglass_viscosity = 0.5; }},
      {"modern, eps 0.1", "modern", [](Numerics& n) { n.artificial_stress = 0.1; }},
      {"cubic spline 1.5", "modern",
       [](Numerics& n) { smooth(n, SmoothingFunction::cubic_spline, 1.5); }},
      {"cubic spline 1.5, hourglass 0.5", "modern",
       [](Numerics& n) {
         smooth(n, SmoothingFunction::cubic_spline, 1.5);
         n.hourglass_viscosity = 0.5;
       }},
      for_tension,
  };
  return all;
}

Scene scene_of(const CaseRun& run, const Setting& setting, double spacing, bool viscous) {
  Scene scene = run.scene_at(spacing, setting.preset);
  setting.apply(scene.numerics);
  if (!viscous) scene.numerics.viscosity_alpha = scene.numerics.viscosity_beta = 0.0;
  return scene;
}

/// The clamped beam, half as long as the free one: a wall holds its end.
Scene clamped(Scene scene) {
  scene.bodies.front().shape = Box{{0.0, -0.5, 0.0}, {5.0, 0.5, 0.0}};
  scene.probes.front().at = {2.5, 0.0, 0.0};
  Wall wall;
  wall.name = "clamp";
  wall.kind = WallKind::no_slip;
  wall.facets = line_facets({{0.0, 2.0}, {0.0, -2.0}});
  scene.walls = {wall};
  return scene;
}

void tell(CaseRun& run, const std::string& who, const Swing& one) {
  const std::string fate =
      one.whole ? "" : fmt::format("the watch stopped it after {:.2g} periods", one.periods);
  run.add(reported(who + "frequency over Timoshenko's", one.frequency, "", fate));
  run.add(reported(who + "deflection over the closed form", one.amplitude, "", fate));
  run.add(reported(who + "energy at the end over its start", one.energy, "", fate));
  if (one.artificial_stress != 0.0) {
    run.add(reported(who + "energy taken by artificial stress", one.artificial_stress, "",
                     "over the start"));
  }
  if (std::fabs(one.gradient_residue) > 1e-3) {
    run.add(reported(who + "energy taken by the gradient's residue", one.gradient_residue, "",
                     "over the start"));
  }
}

/// `modern`: frequency and deflection without viscosity, energy with and without.
void judge_modern(CaseRun& run, std::optional<Simulation>& last) {
  std::vector<ErrorAtSpacing> frequencies;
  const std::vector<double> spacings =
      run.short_form() ? run.spacings({judged_spacing}) : run.spacings({0.2, judged_spacing, 0.05});
  for (const double spacing : spacings) {
    const std::string who = fmt::format("modern, dx = {} m: ", spacing);
    const Scene elastic = scene_of(run, as_it_stands, spacing, false);
    const Swing free = swing(run, fmt::format("modern, dx {} m", spacing), elastic, {}, last);
    frequencies.push_back({spacing, free.frequency - 1.0});
    // What is missed is looked at where there is time for it: see the README.
    const bool judged = spacing == judged_spacing && !run.short_form();
    const auto add = [&](const std::string& name, double value, const std::string& source) {
      run.add(judged ? within(who + name, value, "", 1.0, 0.97, 1.03, source)
                     : reported(who + name, value, ""));
    };
    add("frequency over Timoshenko's", free.frequency, "closed form, 3 %");
    add("deflection over the closed form", free.amplitude, "speed over frequency, 3 %");
    for (const OfEquations& one : of_equations) {
      if (one.spacing != spacing) continue;
      run.add(within(who + "frequency over that of the particle equations",
                     free.frequency / one.frequency, "", 1.0, 0.99, 1.01,
                     "strip.py, an endless beam; 1 %"));
    }
    run.add(reported(who + "spacings missing in the depth",
                     (1.0 - free.frequency) * Beam(elastic).depth / spacing, "",
                     "the frequency goes with the depth"));
    run.add(within(who + "energy after ten periods, no viscosity", free.energy, "", 1.0, 0.98, 1.02,
                   "nothing takes any: 2 %"));
    const Scene damped = scene_of(run, as_it_stands, spacing, true);
    const Swing viscous =
        swing(run, fmt::format("modern, dx {} m, viscous", spacing), damped, {}, last);
    const BendingMode mode(Beam(damped), Support::free_free);
    const double lost = viscous_share(damped, mode, 2.0 * std::numbers::pi * viscous.periods);
    run.add(within(who + "energy after ten periods", viscous.energy, "", 1.0 - lost, 0.98 - lost,
                   1.02, fmt::format("viscosity takes {:.4f} by E26; 2 %", lost)));
    run.add(reported(who + "energy taken by viscosity over E26", viscous.viscous / lost, "",
                     "as on a dense lattice without surfaces"));
  }
  judge_convergence(run, "modern: frequency over Timoshenko's - 1", frequencies,
                    {run.short_form() ? 0.05 : 0.03, 1.8,
                     run.short_form() ? "no worse than 5 %; the band of 3 % is in the main form"
                                      : "closed form, 3 %"});
}

constexpr double large = 0.3;  ///< deflection with strains of 3 % [m]

Swing swung(CaseRun& run, const Setting& setting, double spacing, double deflection,
            std::optional<Simulation>& last) {
  const std::string name =
      fmt::format("{}, dx {} m, deflection {} m", setting.name, spacing, deflection);
  return swing(run, name, scene_of(run, setting, spacing, true),
               {Support::free_free, deflection, 10.0}, last);
}

double kept(const Swing& one) { return one.last_amplitude / one.amplitude; }

/// What larger and larger deflections leave of the mode.
void tell_tension(CaseRun& run, double spacing, std::optional<Simulation>& last) {
  for (const Setting& setting : settings_for_tension()) {
    for (const double deflection : {0.01, 0.03, 0.1, large}) {
      const Swing one = swung(run, setting, spacing, deflection, last);
      const std::string who =
          fmt::format("{}, dx = {} m, deflection of {} m: ", setting.name, spacing, deflection);
      run.add(reported(who + "energy at the end over its start", one.energy, ""));
      run.add(reported(who + "deflection of the last period over the first", kept(one), ""));
      if (deflection == 0.01)
        run.add(reported(who + "frequency over Timoshenko's", one.frequency, ""));
      if (setting.name == as_it_stands.name && deflection == large) {
        run.add(holds(who + "the beam loses its mode", kept(one) < 0.9,
                      "else the case could not tell a setting that holds"));
      }
    }
  }
}

/// A setting holds if no energy comes from nowhere and the beam still swings in its mode.
void judge_tension(CaseRun& run, double spacing, std::optional<Simulation>& last) {
  const Swing one = swung(run, for_tension, spacing, large, last);
  const std::string who =
      fmt::format("{}, dx = {} m, deflection of {} m, judged: ", for_tension.name, spacing, large);
  run.add(holds(who + "ran to its end", one.whole, "the watch did not stop it"));
  run.add(within(who + "largest energy over its start", one.most_energy, "", 1.0, 0.0, 1.02,
                 "no source of energy: 2 %"));
  run.add(within(who + "deflection of the last period over the first", kept(one), "", 1.0, 0.9,
                 1.05, "a beam that breaks has no mode left; 5 % for other modes, 10 % losses"));
}

/// The clamp is known to half a spacing, and the frequency goes with 1/L^2.
void judge_clamped(CaseRun& run, double spacing, std::optional<Simulation>& last) {
  const std::string who = fmt::format("modern, clamped, dx = {} m: ", spacing);
  Scene scene = clamped(scene_of(run, as_it_stands, spacing, false));
  const Beam beam(scene);
  const Start start{Support::clamped_free, small_deflection, run.short_form() ? 2.0 : 5.0};
  const Swing one = swing(run, fmt::format("clamped, dx {} m", spacing), scene, start, last);
  const double band = 0.03 + spacing / beam.length;
  run.add(within(who + "frequency over Timoshenko's", one.frequency, "", 1.0, 1.0 - band,
                 1.0 + band, "3 % as the free beam, and a length known to half a spacing"));
  run.add(within(who + "energy after its periods, no viscosity", one.energy, "", 1.0, 0.98, 1.02,
                 "2 %"));

  const BendingMode mode(beam, Support::clamped_free);
  const double gravity = small_deflection / beam.sag(1.0, beam.length);
  scene.gravity = {0.0, -gravity, 0.0};
  Stage& stage = scene.stages.front();
  stage.until = StageEnd::rest;
  stage.damping = 2.0 * mode.frequency();  // critical
  stage.rest_velocity = 1e-5 * small_deflection * mode.frequency();
  stage.duration = 20.0 / mode.frequency();  // (1 + 20) exp(-20) of the way is left
  scene.bodies.front().velocity_field.clear();
  last = run.solve(fmt::format("sagging, dx {} m", spacing), scene);
  const std::vector<double> position = last->field("position"),
                            displacement = last->field("displacement");
  double sum = 0.0, count = 0.0;
  for (std::size_t k = 0; k < position.size(); k += 3) {
    const double x = position[k] - displacement[k];
    if (x < beam.length - spacing) continue;
    sum -= displacement[k + 1] / beam.sag(gravity, x);
    count += 1.0;
  }
  const std::string name = who + "sag of the end under its weight over the closed form";
  run.add(run.short_form()  // see the README
              ? reported(name, sum / count, "")
              : within(name, sum / count, "", 1.0, 1.0 - 2.0 * band, 1.0 + 2.0 * band,
                       "goes with the frequency to the power -2"));
}

double outcome_of(CaseRun& run, const Scene& scene) {
  std::optional<Simulation> last;
  const Swing one = swing(run, "beam", scene, {Support::free_free, small_deflection, 2.0}, last);
  if (!one.whole) throw SimulationInstability("the watch stopped the beam");
  return std::fabs(one.frequency - 1.0);
}

}  // namespace

const ErrorProblem beam_problem{
    "error of the frequency of the first bending mode", {0.2, 0.1, 0.05, 0.025}, outcome_of};

void beam(CaseRun& run) {
  const double spacing = run.options().spacing > 0.0 ? run.options().spacing : judged_spacing;
  std::optional<Simulation> last;
  for (const std::string& preset : run.presets()) {
    if (preset == "modern") {
      judge_modern(run, last);
      judge_clamped(run, spacing, last);
      judge_tension(run, spacing, last);
      if (!run.short_form()) tell_tension(run, spacing, last);
      if (run.options().form == Form::full) judge_tension(run, 0.5 * spacing, last);
    }
    for (const Setting& setting : other_settings()) {
      if (setting.preset != preset) continue;
      for (const bool viscous : {false, true}) {
        if (run.short_form() && (viscous || run.options().preset.empty())) continue;
        const std::string name = fmt::format("{}{}", setting.name, viscous ? "" : ", no viscosity");
        const Scene scene = scene_of(run, setting, spacing, viscous);
        tell(run, fmt::format("{}, dx = {} m: ", name, spacing), swing(run, name, scene, {}, last));
      }
    }
  }
  run.finish(&*last);
}

}  // namespace scarp::validation
