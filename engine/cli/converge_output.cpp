// SPDX-License-Identifier: BSD-3-Clause
/// A convergence study as text, JSON and CSV.

#include "engine/cli/converge_output.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/output/text_file.hpp"
#include "engine/plain_text.hpp"

namespace scarp::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(double error) {
  if (!std::isfinite(error)) return "unknown";
  return error > 0.0 && error < 1e-4 ? "< 0.01 %" : fmt::format("{:.2g} %", 100.0 * error);
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

std::vector<std::string> advice_sentences(const Study& study) {
  std::vector<std::string> sentences;
  const double coarsest = study.runs.front().spacing, finest = study.runs.back().spacing;
  for (const Advice& advice : study.advice) {
    const double target = 100.0 * advice.target;
    if (!advice.spacing) {
      sentences.push_back(
          fmt::format("For {:g} % no spacing can be named: {} does not settle over "
                      "these three.",
                      target, advice.decided_by));
    } else if (*advice.spacing >= coarsest) {
      sentences.push_back(
          fmt::format("For {:g} % the coarsest of the three, {:g} m, already does: {}.", target,
                      coarsest, readable_duration(advice.wall_s)));
    } else {
      sentences.push_back(
          fmt::format("For {:g} % use a spacing of {:.2g} m: about {} a run ({} decides{}).",
                      target, *advice.spacing, readable_duration(advice.wall_s), advice.decided_by,
                      *advice.spacing < 0.25 * finest ? "; far beyond what was run, a guess" : ""));
    }
  }
  return sentences;
}

std::string study_text(const Study& study) {
  std::string text = fmt::format("{:<34}", "");
  for (const SpacingRun& run : study.runs) {
    text += fmt::format("{:>24}", fmt::format("{:g} m", run.spacing));
  }
  text += fmt::format("{:>8}{:>14}\n", "order", "at spacing 0");
  for (std::size_t q = 0; q < study.quantities.size(); ++q) {
    const Convergence& c = study.quantities[q];
    if (c.quantity.size != q) continue;  // components are in the files
    text += fmt::format("{:<34}", fmt::format("{} [{}]", c.quantity.name, c.quantity.unit));
    for (std::size_t k = 0; k < 3; ++k) {
      text += fmt::format(
          "{:>24}", fmt::format("{:.4g} ({})", c.values[k].value, percent(c.estimate.error[k])));
    }
    const double order = c.estimate.observed_order;
    text += fmt::format(
        "{:>8}{:>14}", std::isfinite(order) ? fmt::format("{:.2f}", order) : "-",
        c.estimate.extrapolated ? fmt::format("{:.4g}", *c.estimate.extrapolated) : "-");
    const std::string remark = scarp::remark(c.estimate);
    text += remark.empty() ? "\n" : fmt::format("  {}\n", remark);
  }
  text += fmt::format("{:<34}", "run time");
  for (const SpacingRun& run : study.runs) {
    text += fmt::format("{:>24}", readable_duration(run.wall_s));
  }
  text += "\nIn brackets: estimated error.\n\n";
  for (const std::string& sentence : advice_sentences(study)) text += sentence + "\n";
  for (const std::string& note : study.notes) text += "note: " + note + "\n";
  return text;
}

std::string study_json(const Study& study, const Scene& scene, const std::string& isa,
                       int threads) {
  Json json{{"format", "scarp converge"},
            {"version", 1},
            {"title", scene.title},
            {"file", scene.file},
            {"preset", scene.numerics.preset},
            {"dimension", study.dimension},
            {"isa", isa},
            {"threads", threads},
            {"runs", Json::array()},
            {"quantities", Json::array()},
            {"advice", Json::array()},
            {"notes", study.notes}};
  for (const SpacingRun& run : study.runs) {
    json["runs"].push_back({{"spacing", run.spacing},
                            {"wall_s", run.wall_s},
                            {"particles", run.particles},
                            {"steps", run.steps},
                            {"mass", run.mass},
                            {"reused", run.reused}});
  }
  for (std::size_t q = 0; q < study.quantities.size(); ++q) {
    const auto& [quantity, values, estimate] = study.quantities[q];
    Json row{{"name", quantity.name},           {"unit", quantity.unit},
             {"component", quantity.size != q}, {"probe", quantity.probe},
             {"values", Json::array()},         {"errors", Json::array()}};
    for (std::size_t k = 0; k < 3; ++k) {
      row["values"].push_back(number(values[k].value));
      row["errors"].push_back(number(estimate.error[k]));
    }
    row["trend"] = word(estimate.trend);
    row["observed_order"] = number(estimate.observed_order);
    row["order"] = number(estimate.order);
    row["extrapolated"] = estimate.extrapolated ? number(*estimate.extrapolated) : Json();
    row["remark"] = remark(estimate);
    json["quantities"].push_back(std::move(row));
  }
  const std::vector<std::string> sentences = advice_sentences(study);
  for (std::size_t a = 0; a < study.advice.size(); ++a) {
    const Advice& advice = study.advice[a];
    json["advice"].push_back({{"target", advice.target},
                              {"spacing", advice.spacing ? number(*advice.spacing) : Json()},
                              {"wall_s", advice.spacing ? number(advice.wall_s) : Json()},
                              {"decided_by", advice.decided_by},
                              {"sentence", sentences[a]}});
  }
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void write_study_csv(const std::string& path, const Study& study) {
  std::vector<std::string> header{"quantity", "unit"};
  for (const SpacingRun& run : study.runs)
    header.push_back(fmt::format("value at {:g} m", run.spacing));
  header.insert(header.end(), {"observed order", "order used", "extrapolated"});
  for (const SpacingRun& run : study.runs) {
    header.push_back(fmt::format("error at {:g} m [%]", run.spacing));
  }
  header.emplace_back("trend");
  CsvFile table(path, header);
  for (const auto& [quantity, values, estimate] : study.quantities) {
    table << quantity.name << quantity.unit;
    for (const ValueAtSpacing& value : values) table << value.value;
    table << estimate.observed_order << estimate.order << estimate.extrapolated.value_or(NAN);
    for (const double error : estimate.error) table << 100.0 * error;
    table << word(estimate.trend);
    table.end_row();
  }
}

}  // namespace scarp::cli
