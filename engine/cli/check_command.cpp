// SPDX-License-Identifier: BSD-3-Clause
/// `scarp check`: what a scene is, what it uses and leaves out, what it will need.

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "engine/check/costs.hpp"
#include "engine/check/forecast.hpp"
#include "engine/check/outputs.hpp"
#include "engine/check/probe.hpp"
#include "engine/check/softer_soil.hpp"
#include "engine/check/start_warnings.hpp"
#include "engine/check/subject.hpp"
#include "engine/check/trial.hpp"
#include "engine/check/warnings.hpp"
#include "engine/cli/check_output.hpp"
#include "engine/cli/commands.hpp"
#include "engine/errors.hpp"
#include "engine/fos/dilation_note.hpp"
#include "engine/particles/shapes.hpp"
#include "engine/plain_text.hpp"
#include "engine/scene/numerics_list.hpp"
#include "engine/scene/smoothing_choice.hpp"

namespace scarp::cli {
namespace {

using Json = nlohmann::ordered_json;
using check::expected_frames;
using check::Forecast;
using check::longest_duration;
using check::OutputTrial;
using check::Subject;
using check::Trial;

/// Neighbours a particle has in the undisturbed lattice, itself not counted: the support is 2h
/// wide.
int lattice_neighbours(const Scene& scene) {
  const double radius = 2.0 * smoothing_ratio_of(scene);  // in spacings
  const int reach = static_cast<int>(radius), high = scene.dimension == 2 ? 0 : reach;
  int count = -1;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      for (int z = -high; z <= high; ++z) count += x * x + y * y + z * z < radius * radius;
    }
  }
  return count;
}

/// As many as there are, rounded to three digits where that is only about how many.
std::size_t shown(double count, bool about) {
  const double digit =
      about && count > 0.0 ? std::pow(10.0, std::floor(std::log10(count)) - 2.0) : 1.0;
  return static_cast<std::size_t>(std::round(count / digit) * digit);
}

Json summary(const Scene& scene, const Subject& subject) {
  const Simulation& simulation = subject.simulation;
  // Walls are as many layers deep at any spacing.
  const double walls = static_cast<double>(simulation.wall_count()) *
                       std::pow(simulation.scene().spacing / scene.spacing, scene.dimension - 1);
  Json json{{"format", "scarp check"},
            {"version", 1},
            {"title", scene.title},
            {"file", scene.file},
            {"dimension", scene.dimension},
            {"preset", scene.numerics.preset},
            {"particles", shown(subject.total, subject.coarser)},
            {"wall_particles", shown(walls, subject.coarser)},
            {"spacing", scene.spacing},
            {"measured_at_spacing", simulation.scene().spacing},
            {"smoothing", smoothing_of(scene).name},
            {"smoothing_length", smoothing_length_of(scene)},
            {"neighbours", lattice_neighbours(scene)},
            {"lattice_moment", simulation.lattice_moment()},
            {"isa", simulation.isa()},
            {"threads", simulation.threads()},
            {"materials", Json::array()},
            {"stages", Json::array()},
            {"probes", Json::array()},
            {"features", Json::array()},
            {"warnings", warnings(scene)},
            {"notes", Json::array()}};
  const std::optional<std::string> dilation = dilation_note(scene);
  if (dilation && looks_reducible(scene)) json["notes"].push_back(*dilation);
  for (const std::string& warning : check::start_warnings(simulation))
    json["warnings"].push_back(warning);
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    json["materials"].push_back({{"name", scene.materials[m].name},
                                 {"model", scene.materials[m].model.name()},
                                 {"particles", shown(subject.particles[m], subject.coarser)},
                                 {"density", scene.materials[m].density},
                                 {"mass_scaling", scene.materials[m].mass_scaling},
                                 {"k0", k0_of(scene, scene.materials[m])}});
  }
  for (const Stage& stage : scene.stages) {
    json["stages"].push_back({{"name", stage.name},
                              {"until", stage.until == StageEnd::rest ? "rest" : "duration"},
                              {"duration", stage.duration.value_or(0.0)},
                              {"strength_reduction", stage.strength_reduction}});
  }
  for (const ProbeParticle& probe : simulation.probe_particles()) {
    if (subject.coarser) break;  // on the scene's own lattice they follow others
    json["probes"].push_back({{"name", probe.probe},
                              {"particle", probe.particle},
                              {"start", probe.start},
                              {"distance", probe.distance},
                              {"tied", probe.tied}});
  }
  for (const UsedFeature& feature : simulation.features()) {
    json["features"].push_back(
        {{"name", feature.name}, {"used", feature.used}, {"note", feature.note}});
  }
  return json;
}

void add_forecast(Json& json, const Trial& trial, const Forecast& forecast) {
  json["time_step"] = trial.time_step;
  json["expected_time_s"] = forecast.simulated;
  json["expected_steps"] = forecast.steps;
  json["expected_wall_s"] = forecast.wall_s;
  json["rehearsal_spacing"] = forecast.rehearsal_spacing;
  json["rehearsal_complete"] = forecast.rehearsal_complete;
  json["particle_steps_per_s"] = json["particles"].get<double>() / trial.seconds_per_step;
  json["state_bytes"] = trial.memory;
  json["trial_failure"] = trial.failure.empty() ? Json() : Json(trial.failure);
}

void add_outputs(Json& json, const Scene& scene, const Forecast& forecast,
                 const OutputTrial& outputs) {
  json["memory_bytes"] = std::llround(outputs.peak_bytes);
  json["frame_bytes"] = std::llround(outputs.frame_bytes);
  json["checkpoint_bytes"] = std::llround(outputs.checkpoint_bytes);
  json["expected_frames"] = std::floor(expected_frames(scene, forecast));
  const std::string warning = check::frames_warning(scene, forecast, outputs);
  if (!warning.empty()) json["warnings"].push_back(warning);
}

void line(std::string_view name, const std::string& value) {
  fmt::print("{:<18}{}\n", name, value);
}

std::string origin(const Forecast& forecast) {
  if (forecast.rehearsal_spacing == 0.0) return "as the start of the run goes";
  return fmt::format("after a rehearsal {}at a spacing of {:.3g} m",
                     forecast.rehearsal_complete < 1.0
                         ? fmt::format("of {:.0f} % ", 100.0 * forecast.rehearsal_complete)
                         : "",
                     forecast.rehearsal_spacing);
}

void print_probes(const Scene& scene, const Simulation& simulation) {
  if (scene.probes.empty() || scene.spacing != simulation.scene().spacing) return;
  fmt::print("\nprobes\n");
  for (const ProbeParticle& probe : simulation.probe_particles()) {
    fmt::print("  {:<20} follows particle {} at {}, {:.3g} m away{}\n", probe.probe, probe.particle,
               point_text(probe.start, scene.dimension), probe.distance,
               probe.tied > 1 ? fmt::format("; a tie of {}, decided by rule", probe.tied) : "");
  }
}

void print(const Scene& scene, const Subject& subject, const Json& json, const Trial& trial,
           const Forecast& forecast) {
  const Simulation& simulation = subject.simulation;
  line("scene", fmt::format("{} ({})", scene.title.empty() ? "untitled" : scene.title,
                            plain_text(scene.file)));
  line("dimension", scene.dimension == 2 ? "2, plane strain" : "3");
  line("particles", fmt::format("{}{} soil, {} wall", subject.coarser ? "about " : "",
                                json["particles"].get<std::size_t>(),
                                json["wall_particles"].get<std::size_t>()));
  line("spacing",
       fmt::format("{:g} m, smoothing length {:g} m", scene.spacing, smoothing_length_of(scene)));
  if (subject.coarser) {
    line("measured",
         fmt::format("at a spacing of {:.3g} m, with {} particles, and scaled: more would "
                     "take longer than seconds",
                     simulation.scene().spacing, simulation.soil_count()));
  }
  line("neighbours", fmt::format("{} per particle, weighted by {}", lattice_neighbours(scene),
                                 smoothing_of(scene).name));
  line("preset", preset_and_changes(scene.numerics));
  line("machine", fmt::format("{}, up to {} threads", simulation.isa(), simulation.threads()));
  line("memory", fmt::format("about {} at its peak, of which {} hold the state",
                             readable_bytes(json["memory_bytes"].get<double>()),
                             readable_bytes(static_cast<double>(trial.memory))));
  const double frames = expected_frames(scene, forecast);
  line("output",
       fmt::format("{} frames of {}, checkpoints of {}",
                   std::isnan(frames) ? "an unknown number of" : fmt::format("{:.0f}", frames),
                   readable_bytes(json["frame_bytes"].get<double>()),
                   readable_bytes(json["checkpoint_bytes"].get<double>())));
  if (trial.time_step > 0.0) line("time step", fmt::format("about {:.3g} s", trial.time_step));
  if (std::isnan(forecast.steps)) {
    line("steps", "unknown: a stage has no limit and did not come to rest in a short rehearsal");
  } else if (trial.time_step > 0.0) {
    const double longest = longest_duration(scene);
    line("steps", fmt::format("about {:.0f} for {:.3g} s{}; {}", forecast.steps, forecast.simulated,
                              std::isnan(longest) ? "" : fmt::format(", at most {:g} s", longest),
                              origin(forecast)));
  }
  if (std::isfinite(forecast.wall_s)) {
    line("run time",
         fmt::format("about {} ({:.3g} M particle-steps/s at the start, without output)",
                     readable_duration(forecast.wall_s),
                     json["particle_steps_per_s"].get<double>() / 1e6));
  }
  const Vec3& g = scene.gravity;
  const double gravity = std::hypot(g[0], g[1], g[2]);
  fmt::print("\nmaterials\n");
  for (const Json& material : json["materials"]) {
    const double density = material["density"].get<double>();
    fmt::print("  {:<20} {:<18} {} particles, {:.4g} kg/m3, which weigh {:.4g} kN/m3\n",
               material["name"].get<std::string>(), material["model"].get<std::string>(),
               material["particles"].get<std::size_t>(), density, 1e-3 * density * gravity);
  }
  fmt::print("\nstages\n");
  for (const Stage& stage : scene.stages) {
    const std::string limit =
        stage.duration ? fmt::format(" {:g} s", *stage.duration) : ", without limit";
    fmt::print("  {:<20} {}{}{}\n", stage.name,
               stage.until != StageEnd::rest ? "for"
               : stage.duration              ? "until rest, at most"
                                             : "until rest",
               limit,
               stage.strength_reduction != 1.0
                   ? fmt::format(", strength reduced by {:g}", stage.strength_reduction)
                   : "");
  }
  print_probes(scene, simulation);
  fmt::print("\n{:<30} {:<10} {}\n", "feature", "", "note");
  for (const UsedFeature& feature : simulation.features()) {
    fmt::print("{:<30} {:<10} {}\n", feature.name, feature.used ? "used" : "left out",
               feature.note);
  }
  for (const Json& warning : json["warnings"]) {
    fmt::print("\nwarning: {}\n", warning.get<std::string>());
  }
  for (const Json& note : json["notes"]) fmt::print("\nnote: {}\n", note.get<std::string>());
  if (!trial.failure.empty()) fmt::print("\nThe first steps already fail: {}\n", trial.failure);
}

/// A probe takes some 3000 steps.
Json probe_of(const Scene& scene, const Subject& subject, const RunOptions& options) {
  constexpr double most_probed = 12000;  // particles
  const Scene probed = check::thinned(scene, subject.total, most_probed);
  if (probed.spacing > subject.simulation.scene().spacing) {
    try {
      return check::probe(Simulation(probed, options));
    } catch (const SceneError&) {  // too coarse for its shapes
    }
  }
  return check::probe(subject.simulation);
}

}  // namespace

int check_command(const CheckArguments& asked) {
  const SceneArguments& arguments = asked.scene;
  const Scene scene = load_scene(arguments);
  Subject subject = check::subject_of(scene, arguments.options);
  Json json = summary(scene, subject);
  if (asked.probe) json["probe"] = probe_of(scene, subject, arguments.options);
  const Trial trial =
      check::scaled(check::try_steps(subject.simulation, asked.patience), subject, scene.spacing);
  const OutputTrial outputs =
      check::scaled(check::try_outputs(subject.simulation), subject.share());
  const Forecast expected = check::forecast(scene, arguments.options, trial, asked.patience);
  add_forecast(json, trial, expected);
  if (const auto note = check::softer_soil_note(scene, expected.wall_s))
    json["notes"].push_back(*note);
  add_outputs(json, scene, expected, outputs);
  if (arguments.json != "-") print(scene, subject, json, trial, expected);
  if (asked.costs) {
    constexpr double most_timed = 50000;  // particles; a variant takes some 20 steps
    json["costs"] =
        check::costs(check::thinned(scene, subject.total, most_timed), arguments.options);
  }
  if (arguments.json != "-" && asked.probe) print_probe(json["probe"]);
  if (arguments.json != "-" && asked.costs) print_costs(json["costs"]);
  if (!arguments.json.empty())
    write_text(arguments.json, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  const bool stable = !asked.probe || json["probe"]["margin"]["stable"].get<double>() >= 1.0;
  return trial.failure.empty() && stable ? ok : unstable;
}

}  // namespace scarp::cli
