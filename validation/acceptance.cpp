// SPDX-License-Identifier: BSD-3-Clause
/// Verdicts, JSON and the console table.

#include "validation/acceptance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/errors.hpp"
#include "engine/output/measure_json.hpp"
#include "engine/output/text_file.hpp"

namespace scarp::validation {

using Json = nlohmann::ordered_json;

namespace {

Json json_of(const ClaimLine& claim) {
  return {{"section", claim.section}, {"quote", claim.quote},
          {"measure", claim.measure}, {"numbers", claim.numbers},
          {"verdict", claim.verdict}, {"sensitivity", claim.sensitivity}};
}

Json facts(const std::filesystem::path& path, const Simulation& simulation,
           const CaseResult& result) {
  write_results(path, simulation,
                {result.case_name, result.wall_s, result.stages, result.measures, result.failure});
  std::ifstream stream(path);
  return Json::parse(stream);
}

std::string limit(double value) {
  return std::isfinite(value) ? fmt::format("{:.4g}", value) : value < 0.0 ? "-inf" : "inf";
}

}  // namespace

Measure reported(std::string name, double value, std::string unit, std::string remark) {
  return {std::move(name), value, std::move(unit), {}, {}, std::move(remark), {}};
}

Measure within(std::string name, double value, std::string unit, std::optional<double> reference,
               double lowest, double highest, std::string source) {
  return {std::move(name),
          value,
          std::move(unit),
          reference,
          std::array<double, 2>{lowest, highest},
          std::move(source),
          value >= lowest && value <= highest};
}

Measure holds(std::string name, bool truth, std::string source) {
  return within(std::move(name), truth ? 1.0 : 0.0, "", 1.0, 1.0, 1.0, std::move(source));
}

double observed_order(const std::vector<ErrorAtSpacing>& errors) {
  double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const ErrorAtSpacing& at : errors) {
    if (!(std::fabs(at.error) > 0.0)) continue;
    const double u = std::log(at.spacing), v = std::log(std::fabs(at.error));
    count += 1.0;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  return count < 2.0 ? std::nan("") : (count * xy - x * y) / (count * xx - x * x);
}

void to_json(Json& json, const RunCost& run) {
  json = {{"name", run.name},
          {"steps", run.steps},
          {"particle_steps", run.particle_steps},
          {"simulated_s", run.simulated_s},
          {"wall_s", run.wall_s},
          {"cpu_s", run.cpu_s},
          {"memory_bytes", run.memory_bytes}};
}

void from_json(const Json& json, RunCost& run) {
  json.at("name").get_to(run.name);
  json.at("steps").get_to(run.steps);
  json.at("particle_steps").get_to(run.particle_steps);
  json.at("simulated_s").get_to(run.simulated_s);
  json.at("wall_s").get_to(run.wall_s);
  json.at("cpu_s").get_to(run.cpu_s);
  json.at("memory_bytes").get_to(run.memory_bytes);
}

bool passed(const CaseResult& result) {
  const auto judged = [](const Measure& measure) { return measure.pass.has_value(); };
  return result.failure.empty() &&
         std::any_of(result.measures.begin(), result.measures.end(), judged) &&
         std::all_of(result.measures.begin(), result.measures.end(),
                     [](const Measure& measure) { return measure.pass.value_or(true); });
}

void write_case_results(const std::filesystem::path& path, const Simulation* simulation,
                        const CaseResult& result) {
  Json json;
  if (simulation != nullptr) {
    json = facts(path, *simulation, result);
  } else {
    json = {{"format", "scarp results"}, {"version", 1}, {"measures", Json::array()}};
    for (const Measure& measure : result.measures) json["measures"].push_back(json_of(measure));
  }
  // A case is many runs; the plain writer knows only the one simulation it was given.
  if (!result.title.empty()) json["title"] = result.title;
  double particle_steps = 0.0, stepping = 0.0;
  std::uint64_t steps = 0;
  json["runs"] = Json::array();
  for (const RunCost& run : result.runs) {
    particle_steps += run.particle_steps;
    stepping += run.wall_s;
    steps += run.steps;
    json["runs"].push_back(run);
  }
  json["convergence"] = Json::array();
  for (const ConvergenceSeries& series : result.convergence) {
    Json one{{"quantity", series.quantity},
             {"order", series.order},
             {"spacing", Json::array()},
             {"error", Json::array()}};
    for (const ErrorAtSpacing& at : series.errors) {
      one["spacing"].push_back(at.spacing);
      one["error"].push_back(at.error);
    }
    json["convergence"].push_back(std::move(one));
  }
  json["claims"] = Json::array();
  for (const ClaimLine& claim : result.claims) json["claims"].push_back(json_of(claim));
  json["case"] = result.case_name;
  json["form"] = result.form;
  json["options"] = result.options;
  json["pass"] = passed(result);
  json["complete"] = result.failure.empty();
  json["failure"] = result.failure.empty() ? Json() : Json(result.failure);
  json["steps"] = steps;
  json["wall_s"] = result.wall_s;
  json["particle_steps_per_s"] = stepping > 0.0 ? Json(particle_steps / stepping) : Json();
  replace_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string console_table(const CaseResult& result) {
  std::size_t width = 10;
  for (const Measure& measure : result.measures) width = std::max(width, measure.name.size());
  std::string text;
  int judged = 0, failed = 0;
  for (const Measure& measure : result.measures) {
    judged += measure.pass.has_value();
    failed += !measure.pass.value_or(true);
    const char* mark = !measure.pass ? "  -   " : *measure.pass ? "pass  " : "FAIL  ";
    std::string against;
    if (measure.band) {
      against = fmt::format("in [{}, {}]", limit((*measure.band)[0]), limit((*measure.band)[1]));
    }
    text +=
        fmt::format("  {}{:<{}}  {:>11} {:<4} {:<22} {}\n", mark, measure.name, width,
                    fmt::format("{:.5g}", measure.value), measure.unit, against, measure.source);
  }
  text += claims_text(result.claims);
  if (!result.failure.empty()) text += fmt::format("  FAIL  {}\n", result.failure);
  text += fmt::format("{} {} ({}): {} of {} judged measures pass, {:.0f} s\n",
                      passed(result) ? "PASS" : "FAIL", result.case_name, result.form,
                      judged - failed, judged, result.wall_s);
  return text;
}

}  // namespace scarp::validation
