// SPDX-License-Identifier: BSD-3-Clause
/// The JSON form of a run's results.

#include "engine/output/results.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <scarp/version.hpp>
#include <thread>

#include "engine/machine.hpp"
#include "engine/output/measure_json.hpp"
#include "engine/output/numerics_json.hpp"
#include "engine/output/text_file.hpp"

namespace scarp {
namespace {

using Json = nlohmann::ordered_json;
constexpr int format_version = 1;

Json json_of(const Instability& what) {
  return {{"step", what.step},         {"time_s", what.time},       {"stage", what.stage},
          {"particle", what.particle}, {"position", what.position}, {"field", what.field},
          {"unit", what.unit},         {"value", what.value},       {"limit", what.limit},
          {"cause", what.cause},       {"advice", what.advice}};
}

Json json_of(const LostSoil& lost) {
  Json json{{"particles", lost.particles}, {"mass", lost.mass}, {"first", Json()}};
  if (lost.particles == 0) return json;
  json["first"] = {{"particle", lost.first},
                   {"step", lost.step},
                   {"time_s", lost.time},
                   {"stage", lost.stage},
                   {"position", lost.position}};
  return json;
}

Json json_of(const ProbeParticle& probe) {
  return {{"name", probe.probe},
          {"particle", probe.particle},
          {"start", probe.start},
          {"distance", probe.distance},
          {"tied", probe.tied}};
}

double norm(const double* v) { return std::hypot(v[0], v[1], v[2]); }

Json verdict(const RunResults& results) {
  if (!results.failure.empty()) return false;
  Json pass;  // null: nothing was judged
  for (const Measure& measure : results.measures) {
    if (measure.pass) pass = *measure.pass && pass != Json(false);
  }
  return pass;
}

}  // namespace

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  std::string numbers;  // ARM tells no name
  for (std::string line; std::getline(info, line) && !line.empty();) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos || colon + 2 >= line.size()) continue;
    std::string value = line.substr(colon + 2);
    if (line.starts_with("model name")) return value;
    if (line.starts_with("CPU implementer")) numbers += "ARM, implementer " + value;
    if (line.starts_with("CPU part")) numbers += ", part " + value;
  }
  return numbers.empty() ? "unknown" : numbers;
}

nlohmann::ordered_json json_of(const Measure& measure) {
  Json json{{"name", measure.name}, {"value", measure.value}, {"unit", measure.unit}};
  json["reference"] = measure.reference ? Json(*measure.reference) : Json();
  json["band"] = measure.band ? Json(*measure.band) : Json();
  json["source"] = measure.source;
  json["pass"] = measure.pass ? Json(*measure.pass) : Json();
  return json;
}

std::string program_version() { return SCARP_VERSION; }

std::vector<Measure> basic_measures(const Simulation& simulation) {
  const Scene& scene = simulation.scene();
  const bool plane = scene.dimension == 2;
  std::vector<Measure> measures;
  const auto report = [&measures](std::string name, double value, std::string unit) {
    measures.push_back({std::move(name), value, std::move(unit), {}, {}, {}, {}});
  };
  const auto fields = simulation.fields();
  if (std::any_of(fields.begin(), fields.end(),
                  [](const FieldInfo& field) { return field.name == "displacement"; })) {
    const std::vector<double> displacement = simulation.field("displacement"),
                              lost = simulation.field("lost");
    double largest = 0.0;
    for (std::size_t i = 0; i + 2 < displacement.size(); i += 3) {
      if (lost[i / 3] == 0.0) largest = std::fmax(largest, norm(&displacement[i]));
    }
    report("largest displacement", largest, "m");
  }
  if (soil_may_sleep(scene)) {
    report("asleep",
           static_cast<double>(simulation.asleep_count()) /
               static_cast<double>(std::max<std::size_t>(1, simulation.soil_count())),
           "-");
  }
  report("residual velocity", simulation.last_step().max_velocity, "m/s");
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  const std::vector<double> density = simulation.field("density"),
                            material_of = simulation.field("material");
  for (std::size_t k = 0; k < density.size(); ++k) {
    const double ratio =
        density[k] / scene.materials[static_cast<std::size_t>(material_of[k])].density;
    least = std::fmin(least, ratio);
    most = std::fmax(most, ratio);
  }
  // Without a critical state dilation has no end: here it shows.
  report("least density over reference density", least, "-");
  report("largest density over reference density", most, "-");
  report("mass", simulation.soil_mass(), plane ? "kg/m" : "kg");
  const EnergyBalance energy = simulation.energy();
  const char* joule = plane ? "J/m" : "J";
  report("kinetic energy", energy.kinetic, joule);
  report("potential energy change in the stage", energy.potential, joule);
  report("elastic energy change in the stage", energy.elastic, joule);
  if (scene.output.energy) report("energy imbalance", energy.imbalance, joule);
  report("actions of the density bounds", static_cast<double>(simulation.density_bound_count()),
         "");
  report("times a grain was held off a face", static_cast<double>(simulation.face_hold_count()),
         "");
  return measures;
}

void write_results(const std::filesystem::path& path, const Simulation& simulation,
                   const RunResults& results) {
  const Scene& scene = simulation.scene();
  const StepReport& last = simulation.last_step();
  const double particle_steps =
      static_cast<double>(simulation.soil_count()) * static_cast<double>(last.step);
  Json json{{"format", "scarp results"},
            {"version", format_version},
            {"case", results.case_name},
            {"title", scene.title},
            {"pass", verdict(results)},
            {"complete", results.failure.empty()},
            {"finished", simulation.finished()},
            {"failure", results.failure.empty() ? Json() : Json(results.failure)},
            {"instability", results.instability ? json_of(*results.instability) : Json()},
            {"lost_soil", json_of(simulation.lost_soil())},
            {"preset", scene.numerics.preset},
            {"precision", word(scene.numerics.precision)},
            {"isa", simulation.isa()},
            {"threads", simulation.threads()},
            {"dimension", scene.dimension},
            {"spacing", simulation.spacing()},
            {"smoothing_length", simulation.smoothing_length()},
            {"particles", simulation.soil_count()},
            {"wall_particles", simulation.wall_count()},
            {"steps", last.step},
            {"simulated_s", last.time},
            {"wall_s", results.wall_seconds},
            {"particle_steps_per_s",
             results.wall_seconds > 0.0 ? Json(particle_steps / results.wall_seconds) : Json()},
            {"memory_bytes", simulation.memory_bytes()},
            {"resident_peak_bytes", std::llround(resident_memory().peak)},
            {"step_limits", Json::object()},
            {"signal_material", scene.materials[last.signal_material].name},
            {"materials", Json::array()},
            {"retries", Json::array()},
            {"measures", Json::array()},
            {"probes", Json::array()},
            {"stages", Json::array()},
            {"profile", Json::array()},
            {"numerics", numerics_json(scene)},
            {"machine",
             {{"processor", processor_name()},
              {"hardware_threads", std::thread::hardware_concurrency()}}},
            {"versions", {{"scarp", program_version()}, {"compiler", __VERSION__}}}};
  for (const Material& material : scene.materials) {
    json["materials"].push_back({{"name", material.name},
                                 {"model", material.model.name()},
                                 {"density", material.density},
                                 {"mass_scaling", material.mass_scaling},
                                 {"k0", k0_of(scene, material)}});
  }
  for (std::size_t k = 0; k < std::size(step_limit_names); ++k)
    json["step_limits"][step_limit_names[k]] = simulation.step_limit_counts()[k];
  for (const Retry& retry : results.retries) {
    json["retries"].push_back({{"step", retry.step},
                               {"back_to", retry.back_to},
                               {"step_factor", retry.step_factor},
                               {"reason", retry.reason}});
  }
  for (const Measure& measure : results.measures) json["measures"].push_back(json_of(measure));
  for (const ProbeParticle& probe : simulation.probe_particles())
    json["probes"].push_back(json_of(probe));
  for (const std::vector<PhaseTime>& times : {simulation.profile(), results.outputs}) {
    for (const PhaseTime& time : times)
      json["profile"].push_back({{"phase", time.phase}, {"wall_s", time.seconds}});
  }
  for (const StageResult& stage : results.stages) {
    json["stages"].push_back({{"name", stage.name},
                              {"end_time_s", stage.end_time},
                              {"end_step", stage.end_step},
                              {"reached_rest", stage.reached_rest}});
  }
  replace_file(path, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace scarp
