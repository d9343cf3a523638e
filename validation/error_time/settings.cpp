// SPDX-License-Identifier: BSD-3-Clause
/// Axes, their choices, and the names of settings.

#include "validation/error_time/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/errors.hpp"
#include "engine/scene/nearest_name.hpp"
#include "engine/scene/numerics_list.hpp"

namespace scarp::validation {
namespace {

template <SmoothingFunction function, int percent>
void smooth(Numerics& numerics) {
  numerics.smoothing = function;
  numerics.smoothing_ratio = percent / 100.0;
}

template <Integrator integrator, int percent>
void integrate(Numerics& numerics) {
  numerics.integrator = integrator;
  numerics.cfl = percent / 100.0;
}

/// Where gradients are not corrected, forces are plain in any case.
void correct_force(Numerics& numerics) { numerics.force_correction = numerics.gradient_correction; }

/// With what served it best: it bears longer steps, and dissipates by itself.
void leave_force_plain(Numerics& numerics) {
  if (!numerics.gradient_correction) return;
  numerics.force_correction = false;
  numerics.cfl = std::fmax(numerics.cfl, 1.0);
  numerics.stress_diffusion = 0.1;
  numerics.diffusion_shear_gate = 20.0;
}

template <int percent>
void resist(Numerics& numerics) {
  numerics.viscosity_alpha = percent / 100.0;
}

template <int percent>
void diffuse(Numerics& numerics) {
  numerics.stress_diffusion = percent / 100.0;
}

}  // namespace

const std::vector<Axis>& numerics_axes() {
  using enum SmoothingFunction;
  using enum Integrator;
  static const std::vector<Axis> axes{
      {"smoothing",
       {{"yang_liu h/dx 1.2", smooth<yang_liu, 120>},
        {"wendland_c2 h/dx 1.2", smooth<wendland_c2, 120>},
        {"wendland_c2 h/dx 1.5", smooth<wendland_c2, 150>},
        {"cubic_spline h/dx 1.2", smooth<cubic_spline, 120>}}},
      {"integrator",
       {{"verlet CFL 0.2", integrate<verlet, 20>},
        {"verlet CFL 0.3", integrate<verlet, 30>},
        {"verlet CFL 0.6", integrate<verlet, 60>},
        {"kick_drift_kick CFL 0.4", integrate<kick_drift_kick, 40>},
        {"kick_drift_kick CFL 0.8", integrate<kick_drift_kick, 80>},
        {"kick_drift_kick CFL 1", integrate<kick_drift_kick, 100>}}},
      {"force", {{"force_correction", correct_force}, {"plain force", leave_force_plain}}},
      {"viscosity",
       {{"viscosity_alpha 0", resist<0>},
        {"viscosity_alpha 0.02", resist<2>},
        {"viscosity_alpha 0.05", resist<5>},
        {"viscosity_alpha 0.1", resist<10>},
        {"viscosity_alpha 0.2", resist<20>}}},
      {"stress_diffusion",
       {{"stress_diffusion 0", diffuse<0>}, {"stress_diffusion 0.15", diffuse<15>}}},
      {"precision",
       {{"double", [](Numerics& n) { n.precision = Precision::real64; }},
        {"mixed", [](Numerics& n) { n.precision = Precision::mixed; }}}},
      {"sleep", {{"sleep 0.05", [](Numerics& n) { n.sleep = 0.05; }}}},
  };
  return axes;
}

std::vector<std::string> axis_names() {
  std::vector<std::string> names{"spacing", "preset"};
  for (const Axis& axis : numerics_axes()) names.emplace_back(axis.name);
  return names;
}

std::vector<std::string> parse_axes(const std::vector<std::string>& given) {
  std::vector<std::string> all = axis_names();
  if (given.empty()) return all;
  std::vector<std::string> chosen;
  for (const std::string& list : given) {
    for (std::size_t start = 0; start <= list.size();) {
      const std::size_t end = std::min(list.find(',', start), list.size());
      const std::string name = list.substr(start, end - start);
      start = end + 1;
      if (std::find(all.begin(), all.end(), name) == all.end()) {
        throw Error(fmt::format("--axis '{}': there is no such axis. {}", name,
                                name.empty()
                                    ? "Try one of " + fmt::format("{}.", fmt::join(all, ", "))
                                    : did_you_mean(name, all)));
      }
      if (std::find(chosen.begin(), chosen.end(), name) == chosen.end()) chosen.push_back(name);
    }
  }
  return chosen;
}

std::string name_of(const Setting& setting) {
  std::vector<std::string_view> changes;
  for (const auto& [axis, choice] : setting.changes) {
    changes.push_back(numerics_axes().at(axis).choices.at(choice).name);
  }
  return setting.preset + (changes.empty() ? "" : " with ") +
         fmt::format("{}", fmt::join(changes, " and "));
}

Numerics numerics_of(const Setting& setting, Numerics of_preset) {
  for (const auto& [axis, choice] : setting.changes) {
    numerics_axes().at(axis).choices.at(choice).apply(of_preset);
  }
  return of_preset;
}

std::string numerics_text(const Numerics& numerics) {
  std::string text = numerics.preset;
  for (const NumericsRow& row : numerics_list) text += fmt::format(" {}", row.get(numerics));
  return text;
}

}  // namespace scarp::validation
