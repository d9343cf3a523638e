// SPDX-License-Identifier: BSD-3-Clause
/// Steps, counts and margin.
#include "engine/cli/probe_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/errors.hpp"
#include "engine/watch/stability_margin.hpp"

namespace scarp::cli {
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

void print_probe(const Json& probed) {
  fmt::print("\nprobe of {} steps, {:.3g} s each on average, at a spacing of {:.3g} m\n",
             probed["steps"].get<std::uint64_t>(), probed["time_step"].get<double>(),
             probed["spacing"].get<double>());
  for (const auto& [limit, count] : probed["step_limits"].items()) {
    if (count.get<std::uint64_t>() > 0)
      fmt::print("  set by {:<12} {:>5} steps\n", limit, count.get<std::uint64_t>());
  }
  fmt::print("  sound is fastest in '{}'\n", probed["signal_material"].get<std::string>());
  if (probed["materials"].size() > 1) {
    for (const Json& material : probed["materials"]) {
      fmt::print("    {:<20} {:.4g} m/s, alone {:.3g} s a step\n",
                 material["name"].get<std::string>(), material["sound_speed"].get<double>(),
                 material["time_step"].get<double>());
    }
  }
  const double cfl = probed["cfl"].get<double>(), stable = probed["margin"]["stable"].get<double>();
  const Json& unstable = probed["margin"]["unstable"];
  if (stable < 1.0) {
    fmt::print("  UNSTABLE at cfl = {:g}; {}\n", cfl,
               stable > 0.0 ? fmt::format("stable at {:.3g}", cfl * stable)
                            : std::string("and at a sixteenth of it"));
  } else if (unstable.is_null()) {
    fmt::print("  margin: stable up to cfl = {:.3g} at least, {:.2g} times that of the scene\n",
               cfl * stable, stable);
  } else {
    fmt::print("  margin: unstable from cfl = {:.3g} on, {:.2g} times that of the scene\n",
               cfl * unstable.get<double>(), unstable.get<double>());
  }
  fmt::print("  closed form for sound on the undisturbed lattice: cfl = {:.3g}\n",
             probed["acoustic_cfl_limit"].get<double>());
  if (!probed["failure"].is_null())
    fmt::print("  The probe became unstable: {}\n", probed["failure"].get<std::string>());
}

}  // namespace scarp::cli
