// SPDX-License-Identifier: BSD-3-Clause
/// JSON, CSV and console forms of a study.

#include "validation/error_time/output.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "validation/error_time/sentences.hpp"

namespace scarp::validation {
namespace {

using Json = nlohmann::ordered_json;

Json changes_of(const Setting& setting) {
  Json changes = Json::object();
  for (const auto& [axis, choice] : setting.changes) {
    const Axis& one = numerics_axes()[axis];
    changes[std::string(one.name)] = one.choices[choice].name;
  }
  return changes;
}

Json json_of(const Point& point) {
  return {{"setting", point.setting},
          {"preset", point.trial.setting.preset},
          {"changes", changes_of(point.trial.setting)},
          {"spacing", point.spacing},
          {"smoothing", word(point.numerics.smoothing)},
          {"smoothing_ratio", *point.numerics.smoothing_ratio},
          {"integrator", word(point.numerics.integrator)},
          {"cfl", point.numerics.cfl},
          {"force_correction", point.numerics.force_correction},
          {"viscosity_alpha", point.numerics.viscosity_alpha},
          {"stress_diffusion", point.numerics.stress_diffusion},
          {"precision", word(point.numerics.precision)},
          {"sleep", point.numerics.sleep},
          {"status", word(point.status)},
          {"reason", point.reason},
          {"reference", point.reference},
          {"on_front", point.on_front},
          {"error", point.error},
          {"wall_s", point.wall_s},
          {"wall_spread", point.spread},
          {"repeats", point.repeats},
          {"cpu_s", point.cpu_s},
          {"particles", point.particles},
          {"steps", point.steps},
          {"particle_steps", point.particle_steps},
          {"memory_bytes", point.memory_bytes}};
}

Json index_or_null(std::optional<std::size_t> index) { return index ? Json(*index) : Json(); }

std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json json_of(const ErrorStudy& study) {
  Json json{{"format", "scarp error time of a case"},
            {"version", 1},
            {"case", study.case_name},
            {"title", study.title},
            {"error", study.error},
            {"short", study.short_form},
            {"spacings", study.spacings},
            {"axes", study.axes},
            {"runs_left_out", study.left_out},
            {"sentences", sentences(study)},
            {"front", study.front},
            {"targets", Json::array()},
            {"points", Json::array()},
            {"isa", study.bench.isa},
            {"threads", study.bench.threads},
            {"machine", {{"processor", study.bench.processor}}},
            {"versions", {{"scarp", study.bench.version}, {"compiler", __VERSION__}}}};
  json["reference"] =
      study.reference
          ? Json{{"value", study.reference->value},
                 {"order", study.reference->order ? Json(*study.reference->order) : Json()}}
          : Json();
  for (const double target : targets) {
    json["targets"].push_back({{"target", target},
                               {"cheapest", index_or_null(cheapest(study, target))},
                               {"modern", index_or_null(cheapest(study, target, "modern"))},
                               {"paper", index_or_null(cheapest(study, target, "paper"))}});
  }
  for (const Point& point : study.points) json["points"].push_back(json_of(point));
  return json;
}

void write_csv(const std::filesystem::path& path, const ErrorStudy& study) {
  // CsvFile adds its rows to a file it opens anew, so the table is always that of this study.
  CsvFile table(path, {"preset",
                       "smoothing",
                       "smoothing_ratio [-]",
                       "integrator",
                       "cfl [-]",
                       "force_correction",
                       "viscosity_alpha [-]",
                       "stress_diffusion [-]",
                       "precision",
                       "sleep [-]",
                       "spacing [m]",
                       "status",
                       "role",
                       "on_front",
                       "error [-]",
                       "wall [s]",
                       "wall_spread [-]",
                       "repeats",
                       "cpu [s]",
                       "particles",
                       "steps",
                       "particle_steps",
                       "memory [bytes]"});
  for (const Point& point : study.points) {
    const Numerics& n = point.numerics;
    table << point.trial.setting.preset << word(n.smoothing) << *n.smoothing_ratio
          << word(n.integrator) << n.cfl << (n.force_correction ? 1.0 : 0.0) << n.viscosity_alpha
          << n.stress_diffusion << word(n.precision) << n.sleep << point.spacing
          << word(point.status) << (point.reference ? "reference" : "compared")
          << (point.on_front ? 1.0 : 0.0) << point.error << point.wall_s << point.spread
          << static_cast<double>(point.repeats) << point.cpu_s << point.particles << point.steps
          << point.particle_steps << point.memory_bytes;
    table.end_row();
  }
}

}  // namespace

void write_study(const std::filesystem::path& folder, const ErrorStudy& study) {
  replace_file(folder / (study.case_name + ".json"), text_of(json_of(study)));
  write_csv(folder / (study.case_name + ".csv"), study);
}

std::string write_overall(const std::filesystem::path& folder) {
  Json json{{"format", "scarp error time"}, {"version", 1}, {"cases", Json::array()}};
  for (const CaseRow& row : case_list) {
    const std::string name(row.name);
    std::ifstream stream(folder / (name + ".json"));
    if (!stream) continue;
    try {
      const Json one = Json::parse(stream);
      json["cases"].push_back({{"case", name},
                               {"sentence", row.sentence},
                               {"error", one.at("error")},
                               {"file", name + ".json"},
                               {"sentences", one.at("sentences")}});
    } catch (const Json::exception& error) {
      throw FileError(fmt::format("'{}': {}. Remove it and measure again.",
                                  (folder / (name + ".json")).string(), error.what()));
    }
  }
  std::string text = text_of(json);
  replace_file(folder / "error_time.json", text);
  return text;
}

std::string study_text(const ErrorStudy& study) {
  std::size_t width = 7;
  for (const std::size_t f : study.front) {
    width = std::max(width, study.points[f].setting.size());
  }
  std::string text = fmt::format("{}: {}; {} settings, the front of error against run time:\n",
                                 study.case_name, study.error, study.points.size());
  text += fmt::format("  {:<{}}  {:>9}  {:>9}  {:>9}  {:>7}\n", "setting", width, "dx [m]", "error",
                      "run time", "spread");
  for (const std::size_t f : study.front) {
    const Point& point = study.points[f];
    text += fmt::format("  {:<{}}  {:>9.4g}  {:>7.2g} %  {:>7.3g} s  {:>7}\n", point.setting, width,
                        point.spacing, 100.0 * point.error, point.wall_s,
                        point.repeats > 1 ? fmt::format("{:.0f} %", 100.0 * point.spread) : "-");
  }
  for (const std::string& line : sentences(study)) text += "  " + line + "\n";
  return text;
}

}  // namespace scarp::validation
