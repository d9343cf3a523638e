// SPDX-License-Identifier: BSD-3-Clause
/// Steps, counts and margin.
#include "engine/check/probe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/check/stability_margin.hpp"
#include "engine/errors.hpp"

namespace scarp::check {
namespace {

using Json = nlohmann::ordered_json;
constexpr int probed_steps = 300;

Json materials_of(const Scene& scene, double step_of_fastest) {
  Json list = Json::array();
  const double fastest = sound_speed(scene);
  for (const Material& material : scene.materials) {
    Scene alone;
    alone.materials = {material};
    const double sound = sound_speed(alone);
    list.push_back({{"name", material.name},
                    {"sound_speed", sound},
                    {"time_step", step_of_fastest * fastest / sound}});
  }
  return list;
}

}  // namespace

Json probe(const Simulation& start) {
  Simulation simulation = start.clone();
  const Scene& scene = simulation.scene();
  Json json{{"spacing", scene.spacing}};
  std::string failure;
  try {
    for (int k = 0; k < probed_steps && !simulation.finished(); ++k) simulation.step();
    simulation.require_sound();
  } catch (const SimulationInstability& instability) {
    failure = instability.what();
  }
  const StepReport& last = simulation.last_step();
  const auto steps = static_cast<double>(std::max<std::uint64_t>(last.step, 1));
  const double time_step = last.step > 0 ? last.time / steps : last.time_step;
  json["steps"] = last.step;
  json["time_step"] = time_step;
  for (std::size_t k = 0; k < std::size(step_limit_names); ++k)
    json["step_limits"][step_limit_names[k]] = simulation.step_limit_counts()[k];
  json["signal_material"] = scene.materials[last.signal_material].name;
  json["materials"] = materials_of(scene, time_step);
  const StabilityMargin margin = stability_margin(start);
  json["cfl"] = scene.numerics.cfl;
  json["margin"] = {{"stable", margin.stable},
                    {"unstable", margin.unstable > 0.0 ? Json(margin.unstable) : Json()}};
  json["acoustic_cfl_limit"] = simulation.acoustic_cfl_limit();
  json["failure"] = failure.empty() ? Json() : Json(failure);
  return json;
}

}  // namespace scarp::check
