// SPDX-License-Identifier: BSD-3-Clause
/// A scene and its variants, taking turns.
#include "engine/check/costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <vector>

#include "engine/errors.hpp"

namespace scarp::check {
namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// The rest of the step stays: a variant is no scene to believe, only one to time.
struct Variant {
  const char* feature;
  bool (*used)(const Scene&);
  void (*leave_out)(Scene&);
};

bool is_plastic(const Material& material) { return material.model.yields(); }

void make_elastic(Scene& scene) {
  for (Material& material : scene.materials) {
    const auto [k, g] = material.model.moduli();
    material.model =
        LinearElastic{9.0 * k * g / (3.0 * k + g), (3.0 * k - 2.0 * g) / (6.0 * k + 2.0 * g)};
  }
}

constexpr Variant variants[]{
    {"artificial viscosity",
     [](const Scene& s) {
       return s.numerics.viscosity_alpha > 0.0 || s.numerics.viscosity_beta > 0.0;
     },
     [](Scene& s) { s.numerics.viscosity_alpha = s.numerics.viscosity_beta = 0.0; }},
    {"artificial stress", [](const Scene& s) { return s.numerics.artificial_stress > 0.0; },
     [](Scene& s) { s.numerics.artificial_stress = 0.0; }},
    {"hourglass viscosity",
     [](const Scene& s) {
       return s.numerics.corrects_force() && s.numerics.hourglass_viscosity > 0.0;
     },
     [](Scene& s) { s.numerics.hourglass_viscosity = 0.0; }},
    {"force correction", [](const Scene& s) { return s.numerics.corrects_force(); },
     [](Scene& s) { s.numerics.force_correction = false; }},
    {"gradient correction", [](const Scene& s) { return s.numerics.gradient_correction; },
     [](Scene& s) { s.numerics.gradient_correction = false; }},
    {"stress diffusion",
     [](const Scene& s) {
       return s.numerics.stress_diffusion > 0.0 &&
              std::any_of(s.materials.begin(), s.materials.end(), is_plastic);
     },
     [](Scene& s) { s.numerics.stress_diffusion = 0.0; }},
    {"plasticity",
     [](const Scene& s) { return std::any_of(s.materials.begin(), s.materials.end(), is_plastic); },
     make_elastic},
    {"energy balance", [](const Scene& s) { return s.output.energy; },
     [](Scene& s) { s.output.energy = false; }},
    {"sums in double precision",
     [](const Scene& s) { return s.numerics.precision == Precision::real64; },
     [](Scene& s) { s.numerics.precision = Precision::mixed; }},
};

/// Seconds per step over at least `enough` seconds.
double seconds_per_step(Simulation& simulation, double enough) {
  const auto start = Clock::now();
  double elapsed = 0.0;
  int steps = 0;
  while (elapsed < enough && !simulation.finished()) {
    simulation.step();
    ++steps;
    elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  }
  return steps > 0 ? elapsed / steps : 0.0;
}

double bytes_per_particle(const Simulation& simulation) {
  return static_cast<double>(simulation.memory_bytes()) /
         static_cast<double>(simulation.soil_count());
}

Json cost_of(const Variant& variant, const Scene& scene, const RunOptions& options) {
  constexpr int turns = 7;
  constexpr double warm_up = 0.1, turn = 0.05;
  Scene without_it = scene;
  variant.leave_out(without_it);
  Simulation with(scene, options), without(without_it, options);
  seconds_per_step(with, warm_up);
  seconds_per_step(without, warm_up);
  std::vector<double> shares;
  for (int k = 0; k < turns; ++k) {
    const double a = seconds_per_step(with, turn), b = seconds_per_step(without, turn);
    if (a > 0.0 && b > 0.0) shares.push_back(1.0 - b / a);
  }
  std::sort(shares.begin(), shares.end());
  return {{"feature", variant.feature},
          {"share_of_step", shares.empty() ? Json() : Json(shares[shares.size() / 2])},
          {"bytes_per_particle", bytes_per_particle(with) - bytes_per_particle(without)}};
}

}  // namespace

Json costs(const Scene& scene, const RunOptions& options) {
  Json list = Json::array();
  Scene endless = scene;  // a stage that ends within the trials would leave nothing to time
  endless.stages[0].until = StageEnd::duration;
  endless.stages[0].duration = 1e9;
  for (const Variant& variant : variants) {
    if (!variant.used(endless)) continue;
    try {
      list.push_back(cost_of(variant, endless, options));
    } catch (const Error&) {  // unstable without it, or from the start: nothing to compare
      list.push_back({{"feature", variant.feature},
                      {"share_of_step", Json()},
                      {"bytes_per_particle", Json()}});
    }
  }
  return list;
}

}  // namespace scarp::check
