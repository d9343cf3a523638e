// SPDX-License-Identifier: BSD-3-Clause
/// Factors of safety as measures, tables and costs.

#include "validation/factor_of_safety.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/cli/search_progress.hpp"
#include "engine/output/text_file.hpp"

namespace scarp::validation {

Slope slope_of(const Scene& scene) {
  const auto& outline = std::get<Polygon>(scene.bodies.front().shape).points;
  const kernels::CoulombStrength soil = *scene.materials.front().model.strength();
  Slope slope;
  slope.base = outline.front()[1];
  slope.surface.assign(outline.rbegin(), outline.rend() - 1);
  // A right side of some height is a wall, not ground.
  if (outline[2][0] == outline[1][0]) slope.surface.pop_back();
  slope.unit_weight = scene.materials.front().density * -scene.gravity[1];
  slope.cohesion = soil.cohesion;
  slope.friction_angle = soil.friction_angle;
  return slope;
}

void write_bishop(const std::filesystem::path& path, const Slope& slope,
                  const BishopResult& bishop) {
  nlohmann::ordered_json json{
      {"method", "Bishop's simplified method, dry"},
      {"factor_of_safety", bishop.factor_of_safety},
      {"circle",
       {{"x", bishop.circle.x}, {"y", bishop.circle.y}, {"radius", bishop.circle.radius}}},
      {"entry", bishop.entry},
      {"exit", bishop.exit},
      {"surface", slope.surface},
      {"base", slope.base}};
  replace_file(path, json.dump(2) + "\n");
}

FactorOfSafety search_factor(CaseRun& run, const std::string& name, StrengthReduction& slope,
                             const SearchOptions& search) {
  const std::string prefix = name.empty() ? "" : name + ", ";
  cli::SearchProgress progress(nullptr, slope.criterion(), search, run.options().quiet);
  bool named = false;
  const auto proceed = [&](const Simulation& now) {
    const double reduction = now.scene().stages.back().strength_reduction;
    if (!named) run.announce(fmt::format("{}SRF {:.4g}", prefix, reduction), now);
    named = true;
    return progress(now);
  };
  return find_factor(slope, search, proceed, [&](const FactorOfSafety& found, const Trial& trial) {
    progress.end();
    progress.learn(found);
    named = false;
    run.add(RunCost{
        fmt::format("{}SRF {:.4g}", prefix, trial.reduction), trial.steps,
        static_cast<double>(trial.steps) * static_cast<double>(slope.settled().soil_count()),
        trial.time, trial.wall_s});
  });
}

void judge_factor(CaseRun& run, const std::string& name, const Bracket& bracket, double reference,
                  const std::string& source) {
  const double factor = bracket.complete ? *bracket.factor() : std::nan("");
  const std::string between =
      fmt::format("{}; lies in [{:.4g}, {:.4g}]", source, bracket.stands.value_or(std::nan("")),
                  bracket.fails.value_or(std::nan("")));
  run.add(within(name, factor, "", reference, 0.96 * reference, 1.04 * reference, between));
}

void write_trials(const std::filesystem::path& path, const FactorOfSafety& found) {
  std::vector<Trial> trials = found.trials;
  std::sort(trials.begin(), trials.end(),
            [](const Trial& a, const Trial& b) { return a.reduction < b.reduction; });
  CsvFile table(path,
                {"SRF [-]", "fails", "crest_displacement [m]", "crest_speed [m/s]", "time [s]"});
  for (const Trial& trial : trials) {
    table << trial.reduction << (trial.fails ? 1.0 : 0.0) << trial.displacement << trial.speed
          << trial.time;
    table.end_row();
  }
}

}  // namespace scarp::validation
