// SPDX-License-Identifier: BSD-3-Clause
/// Lines of the log, files of the map, and what it says.
#include "validation/stability/map_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/checkpoint/scene_text.hpp"
#include "engine/output/text_file.hpp"

namespace scarp::validation {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) { return value ? Json(*value) : Json(); }
std::optional<double> optional_of(const Json& json) {
  return json.is_null() ? std::optional<double>{} : json.get<double>();
}

std::string setting_of(const Cell& cell) {
  const Numerics& n = cell.scene.numerics;
  return n.precision == Precision::mixed ? n.preset + ", mixed" : n.preset;
}

std::string name_of(const Cell& cell) { return fmt::format("{} {}", cell.axis, cell.value); }

void write_csv(const std::filesystem::path& path, const std::vector<CellOutcome>& outcomes) {
  CsvFile table(path, {"group",
                       "axis",
                       "value",
                       "preset",
                       "precision",
                       "verdict",
                       "cfl [-]",
                       "stable_cfl [-]",
                       "unstable_cfl [-]",
                       "limit",
                       "energy_gain [-]",
                       "density_low [-]",
                       "density_high [-]",
                       "yield_overshoot [-]",
                       "lost",
                       "noise [-]",
                       "shear_noise [-]",
                       "residual_velocity [m/s]",
                       "particles",
                       "steps",
                       "wall [s]",
                       "reason"});
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  for (const CellOutcome& one : outcomes) {
    const Cell& cell = one.cell;
    const CellRecord& r = one.record;
    table << cell.group << cell.axis << cell.value << cell.scene.numerics.preset
          << word(cell.scene.numerics.precision) << word(r.verdict) << cell.scene.numerics.cfl
          << r.stable_cfl.value_or(none) << r.unstable_cfl.value_or(none) << r.limit
          << r.energy_gain << r.density_low << r.density_high << r.yield_overshoot << r.lost
          << r.noise << r.shear_noise << r.residual_velocity << r.particles << r.steps << r.wall_s
          << r.reason;
    table.end_row();
  }
}

}  // namespace

std::string cell_key(const Bench& bench, const Cell& cell) {
  return hash_of(fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}\n{}", bench.version, bench.program,
                             bench.isa, bench.threads, name_of(cell), scene_text(cell.scene),
                             cell.bisect, cell.steps, cell.displaced, cell.coincident));
}

Json json_of(const CellRecord& r) {
  return {{"key", r.key},
          {"verdict", word(r.verdict)},
          {"reason", r.reason},
          {"limit", r.limit},
          {"stable_cfl", or_null(r.stable_cfl)},
          {"unstable_cfl", or_null(r.unstable_cfl)},
          {"energy_gain", r.energy_gain},
          {"density_low", r.density_low},
          {"density_high", r.density_high},
          {"yield_overshoot", r.yield_overshoot},
          {"lost", r.lost},
          {"noise", r.noise},
          {"shear_noise", r.shear_noise},
          {"residual_velocity", r.residual_velocity},
          {"particles", r.particles},
          {"steps", r.steps},
          {"wall_s", r.wall_s}};
}

bool read(const Json& json, CellRecord& r) {
  r.key = json.at("key");
  const std::string verdict = json.at("verdict");
  while (word(r.verdict) != verdict) {
    if (r.verdict == Verdict::failed) return false;
    r.verdict = static_cast<Verdict>(static_cast<int>(r.verdict) + 1);
  }
  r.reason = json.at("reason");
  r.limit = json.at("limit");
  r.stable_cfl = optional_of(json.at("stable_cfl"));
  r.unstable_cfl = optional_of(json.at("unstable_cfl"));
  r.energy_gain = number_or_nan(json.at("energy_gain"));
  r.density_low = number_or_nan(json.at("density_low"));
  r.density_high = number_or_nan(json.at("density_high"));
  r.yield_overshoot = number_or_nan(json.at("yield_overshoot"));
  r.lost = number_or_nan(json.at("lost"));
  r.noise = number_or_nan(json.at("noise"));
  r.shear_noise = number_or_nan(json.at("shear_noise"));
  r.residual_velocity = number_or_nan(json.at("residual_velocity"));
  r.particles = number_or_nan(json.at("particles"));
  r.steps = number_or_nan(json.at("steps"));
  r.wall_s = number_or_nan(json.at("wall_s"));
  return true;
}

std::vector<std::string> map_sentences(const std::vector<CellOutcome>& outcomes) {
  std::vector<std::string> lines;
  std::map<std::string, std::map<std::string, int>> counts;
  std::map<std::string, std::pair<double, std::string>> narrowest;
  std::map<std::string, std::map<std::string, Verdict>> by_cell;
  for (const CellOutcome& one : outcomes) {
    const std::string setting = setting_of(one.cell);
    ++counts[setting][word(one.record.verdict)];
    by_cell[name_of(one.cell)][setting] = one.record.verdict;
    if (!one.record.stable_cfl) continue;
    const double margin = *one.record.stable_cfl / one.cell.scene.numerics.cfl;
    const auto known = narrowest.find(setting);
    if (known == narrowest.end() || margin < known->second.first)
      narrowest[setting] = {margin, name_of(one.cell)};
  }
  for (const auto& [setting, verdicts] : counts) {
    std::string line = setting + ":";
    for (const auto& [verdict, count] : verdicts) line += fmt::format(" {} {}", count, verdict);
    lines.push_back(line + ".");
  }
  for (const auto& [setting, least] : narrowest) {
    lines.push_back(
        fmt::format("{}: the narrowest margin is {:.2g} times the CFL number in use, at {}.",
                    setting, least.first, least.second));
  }
  std::map<std::string, std::string> noise;
  for (const CellOutcome& one : outcomes) {
    if (one.cell.group != "noise") continue;
    std::string& series = noise[fmt::format("{}, {}", one.cell.axis, setting_of(one.cell))];
    series += fmt::format("{}{:.3g} and {:.3g} at {}", series.empty() ? "" : ", ", one.record.noise,
                          one.record.shear_noise, one.cell.value);
  }
  for (const auto& [name, series] : noise)
    lines.push_back(
        fmt::format("Noise of the pressure and of the shear stress, {}: {}.", name, series));
  std::string better, worse;
  for (const auto& [cell, verdicts] : by_cell) {
    const auto modern = verdicts.find("modern"), paper = verdicts.find("paper");
    if (modern == verdicts.end() || paper == verdicts.end()) continue;
    if (modern->second == Verdict::holds && paper->second != Verdict::holds)
      better += (better.empty() ? "" : "; ") + cell;
    if (paper->second == Verdict::holds && modern->second != Verdict::holds)
      worse += (worse.empty() ? "" : "; ") + cell;
  }
  const auto or_none = [](const std::string& list) { return list.empty() ? "none" : list; };
  lines.push_back("Holds with modern and not with paper: " + or_none(better) + ".");
  lines.push_back("Holds with paper and not with modern: " + or_none(worse) + ".");
  for (const CellOutcome& one : outcomes) {
    if (one.record.verdict == Verdict::holds) continue;
    lines.push_back(fmt::format("{}, {}: {}: {}", name_of(one.cell), setting_of(one.cell),
                                word(one.record.verdict), one.record.reason));
  }
  return lines;
}

std::string write_map(const std::filesystem::path& folder, const Bench& bench, bool short_form,
                      const std::vector<CellOutcome>& outcomes) {
  Json json{{"format", "scarp stability"},
            {"version", 1},
            {"short", short_form},
            {"pass", std::none_of(outcomes.begin(), outcomes.end(),
                                  [](const CellOutcome& one) {
                                    return one.record.verdict == Verdict::failed;
                                  })},
            {"sentences", map_sentences(outcomes)},
            {"cells", Json::array()},
            {"isa", bench.isa},
            {"threads", bench.threads},
            {"machine", {{"processor", bench.processor}}},
            {"versions", {{"scarp", bench.version}, {"compiler", __VERSION__}}}};
  for (const CellOutcome& one : outcomes) {
    Json cell{{"group", one.cell.group},
              {"axis", one.cell.axis},
              {"value", one.cell.value},
              {"preset", one.cell.scene.numerics.preset},
              {"precision", word(one.cell.scene.numerics.precision)},
              {"cfl", one.cell.scene.numerics.cfl}};
    cell.update(json_of(one.record));
    json["cells"].push_back(std::move(cell));
  }
  std::string text = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  replace_file(folder / "stability.json", text);
  write_csv(folder / "stability.csv", outcomes);
  return text;
}

}  // namespace scarp::validation
