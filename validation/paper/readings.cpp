// SPDX-License-Identifier: BSD-3-Clause
/// Readings of the paper as scenes.

#include "validation/paper/readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/output/text_file.hpp"
#include "engine/run/run.hpp"
#include "validation/paper/nearly_at_rest.hpp"

namespace scarp::validation {
namespace {

/// The slope by Eq. 11 is above its limit at SRF 1 (factor of safety 0.89 in the plane at 12 m), so
/// it settles with more strength than the paper gives it.
constexpr double settling_strength = 1.5;

std::string file_name(std::string text) {
  std::replace(text.begin(), text.end(), ' ', '_');
  text.erase(std::remove(text.begin(), text.end(), ','), text.end());
  return text;
}

StudyRun study_run(const CaseRun& run, const Reading& reading, SlopeShape shape) {
  const Slope3d slope(shape, reading.size);
  const Cone cone = slope.plane() ? reading.plane_cone : reading.cone;
  Scene scene = slope.scene(run.scene_at(reading.spacing, reading.preset));
  scene.materials.front().model.set("cone", static_cast<double>(cone));
  if (cone == Cone::plane_strain) scene.stages.front().strength_reduction = 1.0 / settling_strength;
  StudyRun study;
  study.name = fmt::format("{}, {} cone, {}, {:g} m high, dx {:.3g} m", words(shape),
                           cone == Cone::outer ? "outer" : "plane strain", scene.numerics.preset,
                           reading.size.height, reading.spacing);
  study.folder = file_name(study.name);
  scene.file.clear();  // it is no longer what the file says
  study.scene = std::move(scene);
  return study;
}

/// readings.json, which tells the figures whose runs lie in which folder.
void write_readings(const CaseRun& run, const std::vector<Reading>& list,
                    const std::vector<ReadingOutcomes>& all) {
  using Json = nlohmann::ordered_json;
  Json json{{"format", "scarp readings"}, {"version", 1}};
  json["slide_share"] = slide_share;
  json["readings"] = Json::array();
  for (std::size_t k = 0; k < all.size(); ++k) {
    Json one{{"name", all[k].reading},
             {"spacing", list[k].spacing},
             {"height", list[k].size.height},
             {"foundation", list[k].size.foundation},
             {"crest", list[k].size.crest}};
    for (const auto& [shape, outcome] : all[k].outcomes) {
      one["runs"][words(shape)] = outcome.folder;
    }
    json["readings"].push_back(std::move(one));
  }
  replace_file(run.folder() / "readings.json", json.dump(2) + "\n");
}

Observer observer_of(const Slope3d& slope) {
  return {[slope](const Simulation& now, Outcome& outcome) {
            if (now.stage_index() > 0) watch_probes(now, slope, outcome);
          },
          [slope](const Simulation& now) { return nearly_at_rest(now, slope.top()); },
          [slope](const Simulation& now, Outcome& outcome) {
            if (now.stage_index() == 0) measure_settled(now, slope, outcome);
            if (now.finished()) measure_slide(now, slope, outcome);
          }};
}

}  // namespace

std::vector<Reading> readings(const CaseRun& run, const ReadingPlan& plan) {
  const CaseOptions& options = run.options();
  Reading base;
  base.name = "base";
  base.preset = options.preset;
  base.spacing = options.spacing > 0.0 ? options.spacing : run.short_form() ? 1.0 : 0.5;
  std::vector<Reading> all{base};
  const auto add = [&](const std::string& name, double spacing) -> Reading& {
    all.push_back(base);
    all.back().name = name;
    all.back().spacing = spacing;
    return all.back();
  };
  add("2D by Eq. 11", base.spacing).plane_cone = Cone::plane_strain;
  if (options.form != Form::full) return all;
  const double other = base.spacing * plan.other_spacing, coarse = std::max(base.spacing, other);
  const std::string other_name = fmt::format("dx {:.3g} m", other);
  const std::string at = coarse > base.spacing ? " at " + other_name : "";
  Reading& eq11 = add("all by Eq. 11" + at, coarse);
  eq11.cone = eq11.plane_cone = Cone::plane_strain;
  const std::string preset = options.preset == "paper" ? "modern" : "paper";
  add("preset " + preset + at, coarse).preset = preset;
  add("14 m high" + at, coarse).size.height = 14.0;
  add(other_name, other);
  return all;
}

std::vector<PlannedRun> planned_runs(const CaseRun& run, const ReadingPlan& plan) {
  std::vector<PlannedRun> planned;
  for (const Reading& reading : readings(run, plan)) {
    for (const SlopeShape shape : plan.shapes) {
      StudyRun study = study_run(run, reading, shape);
      const bool known = std::any_of(planned.begin(), planned.end(), [&](const PlannedRun& other) {
        return other.name == study.name;
      });
      if (known || (run.options().resume && is_finished(run, study))) continue;
      const double simulated = total_duration(study.scene);
      planned.push_back({study.name, std::move(study.scene), simulated});
    }
  }
  return planned;
}

std::vector<ReadingOutcomes> run_readings(CaseRun& run, const ReadingPlan& plan) {
  std::vector<ReadingOutcomes> all;
  std::map<std::string, Outcome> known;
  for (const Reading& reading : readings(run, plan)) {
    ReadingOutcomes one;
    one.reading = reading.name;
    one.size = reading.size;
    for (const SlopeShape shape : plan.shapes) {
      const StudyRun study = study_run(run, reading, shape);
      auto place = known.find(study.folder);
      if (place == known.end()) {
        Outcome outcome = outcome_of(run, study, observer_of(Slope3d(shape, reading.size)));
        place = known.emplace(study.folder, std::move(outcome)).first;
      }
      one.outcomes[shape] = place->second;
    }
    all.push_back(std::move(one));
  }
  write_readings(run, readings(run, plan), all);
  return all;
}

void add_outcomes_of(const std::string& case_name, const CaseRun& run, const ReadingPlan& plan,
                     std::vector<ReadingOutcomes>& all) {
  const std::vector<Reading> list = readings(run, plan);
  for (std::size_t k = 0; k < list.size(); ++k) {
    for (const SlopeShape shape : plan.shapes) {
      // The same scene whichever case makes it, so that its key tells whether it is the one.
      const StudyRun study = study_run(run, list[k], shape);
      const auto outcome = read_outcome(run.options().out / case_name / study.folder);
      if (outcome && outcome->complete && outcome->key == outcome_key(study.scene)) {
        all[k].outcomes[shape] = *outcome;
      }
    }
  }
}

double failed_after(const Outcome& outcome, const std::string& probe) {
  if (outcome.values.count("end of the slide [s]") == 0) return std::nan("");
  const double time = outcome.at(probe + ": failed after [s]");
  return std::isnan(time) ? INFINITY : time;
}

void judge_claims(CaseRun& run, std::span<const ReadingClaim> claims,
                  const std::vector<ReadingOutcomes>& readings) {
  for (const ReadingClaim& claim : claims) {
    std::vector<NamedFinding> findings;
    for (const ReadingOutcomes& reading : readings) {
      findings.push_back({reading.reading, claim.find(reading)});
    }
    run.add(judge_claim(claim.section, claim.quote, claim.measure, findings));
  }
}

}  // namespace scarp::validation
