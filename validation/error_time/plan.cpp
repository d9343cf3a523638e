// SPDX-License-Identifier: BSD-3-Clause
/// Rounds of trials.

#include "validation/error_time/plan.hpp"

#include <algorithm>
#include <set>

namespace scarp::validation {
namespace {

constexpr std::size_t usual_level = 2;  ///< where the spacing is no axis

bool named(const PlanOptions& options, std::string_view axis) {
  return std::find(options.axes.begin(), options.axes.end(), axis) != options.axes.end();
}

/// Levels that are compared, coarse to fine.
std::vector<std::size_t> compared_levels(const PlanOptions& options, bool whole_preset) {
  if (options.short_form) {
    return options.against_finest ? std::vector<std::size_t>{0} : std::vector<std::size_t>{0, 1};
  }
  if (!named(options, "spacing")) return {usual_level};
  std::vector<std::size_t> levels{0, 1, 2};
  if (whole_preset && !options.against_finest) levels.push_back(3);
  return levels;
}

/// The reference after the two next coarser runs of its setting, from which its limit is told.
std::vector<Trial> reference_series(const PlanOptions& options) {
  std::vector<Trial> series;
  if (const std::optional<Trial> reference = reference_trial(options)) {
    const std::size_t coarser = std::min<std::size_t>(reference->level, 2);
    for (std::size_t level = reference->level - coarser; level <= reference->level; ++level) {
      series.push_back({reference->setting, level});
    }
  }
  return series;
}

/// One change each, of the axes asked for, that the preset does not make itself.
std::vector<Setting> variants(const std::string& preset, const Numerics& own,
                              const PlanOptions& options) {
  std::vector<Setting> settings;
  const std::vector<Axis>& axes = numerics_axes();
  for (std::size_t a = 0; a < axes.size(); ++a) {
    if (!named(options, axes[a].name)) continue;
    for (std::size_t c = 0; c < axes[a].choices.size(); ++c) {
      Setting setting{preset, {{a, c}}};
      if (numerics_text(numerics_of(setting, own)) == numerics_text(own)) continue;
      settings.push_back(std::move(setting));
      if (options.short_form) break;
    }
  }
  return settings;
}

}  // namespace

std::size_t finest_level(const PlanOptions& options) { return options.short_form ? 1 : 3; }

std::optional<Trial> reference_trial(const PlanOptions& options) {
  if (!options.against_finest) return {};
  return Trial{{"modern", {}}, finest_level(options)};
}

std::vector<Trial> first_round(const PresetNumerics& presets, const PlanOptions& options) {
  // Presets first: their run times forecast the others', and the reference gives errors at all.
  std::vector<Trial> trials;
  std::vector<Setting> changed;
  for (const auto& [preset, own] : presets) {
    if (preset != "modern" && !named(options, "preset")) continue;
    for (const std::size_t level : compared_levels(options, true)) {
      trials.push_back({{preset, {}}, level});
    }
    const bool few = options.short_form && preset != "modern";
    if (few) continue;
    const std::vector<Setting> of_preset = variants(preset, own, options);
    changed.insert(changed.end(), of_preset.begin(), of_preset.end());
  }
  std::stable_sort(trials.begin(), trials.end(),
                   [](const Trial& a, const Trial& b) { return a.level < b.level; });
  for (const Trial& trial : reference_series(options)) {
    if (std::find(trials.begin(), trials.end(), trial) == trials.end()) trials.push_back(trial);
  }
  for (const std::size_t level : compared_levels(options, false)) {
    for (const Setting& setting : changed) trials.push_back({setting, level});
  }
  return trials;
}

std::vector<Trial> neighbour_round(const std::vector<TrialOutcome>& tried,
                                   const PlanOptions& options) {
  std::vector<ErrorTime> points;
  std::set<Trial> known;
  for (const TrialOutcome& one : tried) {
    points.push_back(one.at);
    known.insert(one.trial);
  }
  const std::vector<bool> near = near_front(points, near_factor);
  std::vector<Trial> next;
  const auto add = [&](Trial trial) {
    if (known.insert(trial).second) next.push_back(std::move(trial));
  };
  for (std::size_t i = 0; i < tried.size(); ++i) {
    const Trial& one = tried[i].trial;
    if (!near[i] || one.setting.changes.empty()) continue;
    for (std::size_t j = i + 1; j < tried.size(); ++j) {
      const Trial& other = tried[j].trial;
      if (!near[j] || other.level != one.level || other.setting.preset != one.setting.preset) {
        continue;
      }
      Setting both = one.setting;
      bool apart = !other.setting.changes.empty();
      for (const auto& change : other.setting.changes) apart &= both.changes.insert(change).second;
      if (apart) add({std::move(both), one.level});
    }
    const bool to_finest = !options.against_finest && named(options, "spacing") &&
                           one.level + 1 == finest_level(options);
    if (to_finest) add({one.setting, one.level + 1});
  }
  std::stable_sort(next.begin(), next.end(),
                   [](const Trial& a, const Trial& b) { return a.level < b.level; });
  return next;
}

}  // namespace scarp::validation
