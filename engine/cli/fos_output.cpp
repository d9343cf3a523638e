// SPDX-License-Identifier: BSD-3-Clause
/// A factor of safety as text and JSON.

#include "engine/cli/fos_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/fos/dilation_note.hpp"
#include "engine/plain_text.hpp"

namespace scarp::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Less soil that yields while it settles is not worth a word.
constexpr double told_share = 0.01;

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

std::string judged_point(const Criterion& criterion) {
  return criterion.probe.empty() ? std::string("the soil that moves most")
                                 : fmt::format("probe '{}'", criterion.probe);
}

std::string criterion_sentence(const Criterion& criterion) {
  const std::string how =
      criterion.ramp > 0.0 ? fmt::format("The strength is cut by 1.5 in {:.3g} s.", criterion.ramp)
                           : std::string("The strength is cut at once.");
  return fmt::format(
      "{} Failed means: until {:.3g} s after that {} has moved more than {:.3g} m, 1 % of the "
      "slope's height of {:.4g} m, beyond its elastic response of {:.2g} m.",
      how, criterion.window, judged_point(criterion), criterion.limit, criterion.height,
      criterion.elastic);
}

std::string resolution_sentence(const Criterion& criterion, const Scene& scene) {
  const double rows = criterion.height / scene.spacing;
  return fmt::format(
      "The slope is {:.3g} spacings high (dx = {:g} m), and the factor depends on that: the soil "
      "has "
      "no internal length. In finite elements factors by strength reduction fall with refinement "
      "(1.421, 1.387, 1.365 on three meshes of Griffiths and Lane's first example, KATAI 2D); here "
      "a "
      "coarsely drawn toe can make them rise as well. Run it again with --spacing \"{:g} m\": what "
      "changes is the uncertainty.{}",
      rows, scene.spacing, 0.5 * scene.spacing,
      rows < 20.0 ? " Under 20 spacings in the height count on several per cent." : "");
}

/// How much of the soil yielded on its way to rest.
struct Yielded {
  double share = 0.0, most = 0.0;  ///< of the particles; largest plastic strain
};

Yielded yielded_of(const Simulation& settled) {
  const std::vector<double> strain = settled.field("accumulated_plastic_strain");
  const auto count = std::count_if(strain.begin(), strain.end(), [](double e) { return e > 0.0; });
  return {static_cast<double>(count) / static_cast<double>(strain.size()),
          *std::max_element(strain.begin(), strain.end())};
}

std::vector<std::string> notes(const FosReport& report, const Simulation& settled) {
  const Scene& scene = settled.scene();
  std::vector<std::string> found;
  const Bracket& bracket = report.found.bracket;
  if (bracket.stands && !bracket.fails && report.failure.empty()) {
    found.push_back(fmt::format("The slope stands at every factor up to {:g}.", *bracket.stands));
  }
  if (bracket.fails && !bracket.stands && report.failure.empty()) {
    found.push_back(fmt::format("The slope fails at every factor down to {:g}.", *bracket.fails));
  }
  if (!report.settled_at_rest) {
    found.push_back(
        "The slope had not come to rest when the time of its last stage before the cut was up: "
        "what "
        "still moved counts as elastic response. Give that stage a longer duration.");
  }
  if (report.strengthening > 1.0) {
    found.push_back(
        fmt::format("The slope fails with the strength that its settling stages give it. It was "
                    "settled with {:g} times that strength, which the trials cut from there.",
                    report.strengthening));
  }
  if (const Yielded yielded = yielded_of(settled); yielded.share >= told_share) {
    found.push_back(fmt::format(
        "While it settled, {:.0f} % of the soil yielded, by a plastic strain of up to {:.2g}: the "
        "stress at rest is one of those that it can have, and depends a little on how that stage "
        "damps. A k0 that the soil bears lets less of it yield.",
        100.0 * yielded.share, yielded.most));
  }
  if (const auto note = dilation_note(scene, bracket.factor())) found.push_back(*note);
  if (settled.lost_soil().particles > 0)
    found.push_back("While it settled, " + settled.lost_soil().message(settled.soil_count()));
  const Stage& last = scene.stages.back();
  if (last.damping > 0.0) {
    found.push_back(fmt::format(
        "Stage '{}' damps with {:g} 1/s: a slope that fails may not move far enough within the "
        "window, and the factor comes out too high.",
        last.name, *last.damping));
  }
  if (scene.probes.empty()) {
    found.push_back(
        "The scene has no probe, so the largest displacement of any particle is judged: a single "
        "grain that rolls down the face counts as failure. A probe at the crest is the better "
        "measure.");
  }
  return found;
}

double total_wall(const FosReport& report) {
  double total = report.settle_wall_s + report.found.elastic.wall_s;
  for (const Trial& trial : report.found.trials) total += trial.wall_s;
  return total;
}

}  // namespace

const char* word(TrialEnd end) {
  switch (end) {
    case TrialEnd::limit_crossed:
      return "limit crossed";
    case TrialEnd::came_to_rest:
      return "came to rest";
    case TrialEnd::window_over:
      return "window over";
  }
  return "";
}

Json json_of(const Trial& trial) {
  return {{"reduction", trial.reduction}, {"fails", trial.fails},
          {"end", word(trial.end)},       {"displacement", trial.displacement},
          {"speed", trial.speed},         {"time", trial.time},
          {"steps", trial.steps},         {"wall_s", trial.wall_s}};
}

std::string trial_sentence(const Trial& trial, const Bracket& bracket) {
  std::string text =
      fmt::format("SRF {:.4g} {}: {:.3g} m after {:.3g} s ({}); {:.1f} s of run time",
                  trial.reduction, trial.fails ? "fails" : "stands", trial.displacement, trial.time,
                  word(trial.end), trial.wall_s);
  if (bracket.stands && bracket.fails) {
    text += fmt::format("; factor of safety in {:.4g} .. {:.4g}", *bracket.stands, *bracket.fails);
  }
  return text;
}

std::string fos_text(const FosReport& report, const Simulation& settled) {
  const Scene& scene = settled.scene();
  const Bracket& bracket = report.found.bracket;
  std::string text;
  if (const std::optional<double> factor = bracket.factor()) {
    text += fmt::format("factor of safety {:.3f}, between {:.4g} (stands) and {:.4g} (fails){}\n",
                        *factor, *bracket.stands, *bracket.fails,
                        bracket.complete ? "" : "; the search was not finished");
  } else {
    text += "no factor of safety was found\n";
  }
  text += fmt::format("{:>10}{:>9}{:>18}{:>12}{:>10}{:>11}  {}\n", "SRF", "", "displacement [m]",
                      "speed [m/s]", "after [s]", "run [s]", "because");
  std::vector<Trial> trials = report.found.trials;
  std::sort(trials.begin(), trials.end(),
            [](const Trial& a, const Trial& b) { return a.reduction < b.reduction; });
  for (const Trial& trial : trials) {
    text += fmt::format("{:>10.4f}{:>9}{:>18.4g}{:>12.3g}{:>10.3g}{:>11.1f}  {}\n", trial.reduction,
                        trial.fails ? "fails" : "stands", trial.displacement, trial.speed,
                        trial.time, trial.wall_s, word(trial.end));
  }
  text += criterion_sentence(report.criterion) + "\n";
  text += resolution_sentence(report.criterion, scene) + "\n";
  for (const std::string& note : notes(report, settled)) text += "note: " + note + "\n";
  text += fmt::format("{} particles, {}\n", settled.soil_count(),
                      readable_duration(total_wall(report)));
  return text;
}

std::string fos_json(const FosReport& report, const Simulation& settled) {
  const Scene& scene = settled.scene();
  const Criterion& criterion = report.criterion;
  const Bracket& bracket = report.found.bracket;
  Json json{{"format", "scarp fos"},
            {"version", 1},
            {"title", scene.title},
            {"file", scene.file},
            {"complete", bracket.complete && report.failure.empty()},
            {"failure", report.failure.empty() ? Json() : Json(report.failure)},
            {"factor_of_safety", number(bracket.factor())},
            {"stands", number(bracket.stands)},
            {"fails", number(bracket.fails)},
            {"preset", scene.numerics.preset},
            {"dimension", scene.dimension},
            {"spacing", scene.spacing},
            {"particles", settled.soil_count()},
            {"isa", settled.isa()},
            {"threads", settled.threads()},
            {"criterion",
             {{"height", criterion.height},
              {"spacings_in_height", criterion.height / scene.spacing},
              {"limit", criterion.limit},
              {"elastic", criterion.elastic},
              {"ramp", criterion.ramp},
              {"window", criterion.window},
              {"probe", criterion.probe.empty() ? Json() : Json(criterion.probe)},
              {"sentence", criterion_sentence(criterion)}}},
            {"resolution", resolution_sentence(criterion, scene)},
            {"settle",
             {{"time", report.settle_time},
              {"strengthening", report.strengthening},
              {"reached_rest", report.settled_at_rest},
              {"wall_s", report.settle_wall_s}}},
            {"elastic", json_of(report.found.elastic)},
            {"trials", Json::array()},
            {"wall_s", total_wall(report)},
            {"notes", notes(report, settled)}};
  const Yielded yielded = yielded_of(settled);
  json["settle"]["yielded_share"] = yielded.share;
  json["settle"]["plastic_strain"] = yielded.most;
  for (const Trial& trial : report.found.trials) json["trials"].push_back(json_of(trial));
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

std::vector<std::string> trial_titles() {
  return {"SRF [-]",  "fails", "displacement [m]", "speed [m/s]",
          "time [s]", "steps", "run_time [s]"};
}

std::vector<double> trial_cells(const Trial& trial) {
  return {trial.reduction, trial.fails ? 1.0 : 0.0,          trial.displacement, trial.speed,
          trial.time,      static_cast<double>(trial.steps), trial.wall_s};
}

}  // namespace scarp::cli
