// SPDX-License-Identifier: BSD-3-Clause
/// Sentences from points.

#include "validation/error_time/sentences.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/plain_text.hpp"
#include "validation/acceptance.hpp"

namespace scarp::validation {
namespace {

/// A last halving that takes away less than a fifth of the error (order 0.3) is not convergence.
constexpr double falls_below = 0.8;

std::string percent(double error) {
  return error < 0.995 ? fmt::format("{:.2g} %", 100.0 * error)
                       : fmt::format("{:.0f} %", 100.0 * error);
}

std::string duration(double wall_s) {
  return wall_s < 1.0 ? fmt::format("{:.2g} s", wall_s) : readable_duration(wall_s);
}

/// "10 %, 5 % and 2 %".
std::string enumeration(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    text += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words[k];
  }
  return text;
}

bool usable(const Point& point) { return std::isfinite(point.error); }

std::optional<std::size_t> least_error(const ErrorStudy& study, const std::string& preset = {}) {
  std::optional<std::size_t> least;
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const Point& point = study.points[i];
    if (!usable(point) || (!preset.empty() && point.trial.setting.preset != preset)) continue;
    if (!least || point.error < study.points[*least].error) least = i;
  }
  return least;
}

std::string place(const Point& point) {
  return fmt::format("{} at dx = {:g} m", point.setting, point.spacing);
}

/// Targets with the same answer share a sentence.
void say_targets(const ErrorStudy& study, std::vector<std::string>& lines) {
  for (std::size_t k = 0; k < targets.size();) {
    const std::optional<std::size_t> answer = cheapest(study, targets[k]);
    std::vector<std::string> wanted;
    do {
      wanted.push_back(percent(targets[k++]));
    } while (k < targets.size() && cheapest(study, targets[k]) == answer);
    if (answer) {
      const Point& point = study.points[*answer];
      lines.push_back(fmt::format("For {} take {}: {} a run, error {}.", enumeration(wanted),
                                  place(point), duration(point.wall_s), percent(point.error)));
    } else if (const auto least = least_error(study)) {
      const Point& point = study.points[*least];
      lines.push_back(fmt::format("Nothing tried reaches {}: the least error is {} ({}, {}).",
                                  enumeration(wanted), percent(point.error), place(point),
                                  duration(point.wall_s)));
    }
  }
}

/// The preset as it stands, coarse to fine.
std::vector<ErrorAtSpacing> own_errors(const ErrorStudy& study, const std::string& preset) {
  std::vector<ErrorAtSpacing> errors;
  for (const Point& point : study.points) {
    if (usable(point) && point.trial.setting == Setting{preset, {}}) {
      errors.push_back({point.spacing, point.error});
    }
  }
  std::sort(errors.begin(), errors.end(),
            [](const ErrorAtSpacing& a, const ErrorAtSpacing& b) { return a.spacing > b.spacing; });
  return errors;
}

bool changes_smoothing(const Setting& setting) {
  return std::any_of(setting.changes.begin(), setting.changes.end(), [](const auto& change) {
    return numerics_axes()[change.first].name == "smoothing";
  });
}

/// The least error of a preset's variants if it is clearly below `own`, and what it points to if
/// the preset as it stands does not converge.
std::string say_variants(const ErrorStudy& study, const std::string& preset, double own,
                         bool stays) {
  const std::optional<std::size_t> best = least_error(study, preset);
  if (!best || study.points[*best].error >= falls_below * own) return {};
  const Point& point = study.points[*best];
  std::string line = fmt::format(" The least of its variants is {} ({}, {}).", percent(point.error),
                                 place(point), duration(point.wall_s));
  const auto moment = study.lattice_moments.find(preset);
  if (stays && moment != study.lattice_moments.end() && changes_smoothing(point.trial.setting)) {
    line += fmt::format(
        " Where another smoothing function helps, the lattice moment is at fault: {:.3f} instead "
        "of 1, at every spacing (THEORY.md, section 2).",
        moment->second);
  }
  return line;
}

void say_preset(const ErrorStudy& study, const std::string& preset,
                std::vector<std::string>& lines) {
  const std::vector<ErrorAtSpacing> errors = own_errors(study, preset);
  if (errors.size() < 2) return;
  std::vector<std::string> series;
  double least = errors.front().error;
  for (const ErrorAtSpacing& one : errors) {
    series.push_back(fmt::format("{} at {:g} m", percent(one.error), one.spacing));
    least = std::min(least, one.error);
  }
  const bool stays = errors.back().error > falls_below * errors[errors.size() - 2].error;
  const std::string line =
      stays ? fmt::format(
                  "The preset {} as it stands never gets below {} here: the last refinement takes "
                  "less than a fifth of its error away ({}).",
                  preset, percent(least), enumeration(series))
            : fmt::format(
                  "The error of the preset {} as it stands falls with the spacing: {}; order "
                  "{:.1f}.",
                  preset, enumeration(series), observed_order(errors));
  lines.push_back(line + say_variants(study, preset, least, stays));
}

void say_failures(const ErrorStudy& study, RunStatus status, const std::string& words,
                  std::vector<std::string>& lines) {
  std::map<std::string, std::vector<std::string>> places;
  for (const Point& point : study.points) {
    if (point.status == status) {
      places[point.setting].push_back(fmt::format("{:g} m", point.spacing));
    }
  }
  std::vector<std::string> settings;
  for (const auto& [setting, spacings] : places) {
    settings.push_back(fmt::format("{} (dx = {})", setting, fmt::join(spacings, ", ")));
  }
  if (!settings.empty()) lines.push_back(fmt::format("{}: {}.", words, fmt::join(settings, "; ")));
}

}  // namespace

std::optional<std::size_t> cheapest(const ErrorStudy& study, double target,
                                    const std::string& preset) {
  std::vector<std::size_t> good;
  double least_wall = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < study.points.size(); ++i) {
    const Point& point = study.points[i];
    if (!usable(point) || point.error > target) continue;
    if (!preset.empty() && point.trial.setting.preset != preset) continue;
    good.push_back(i);
    least_wall = std::min(least_wall, point.wall_s);
  }
  std::optional<std::size_t> best;
  for (const std::size_t i : good) {
    const Point& point = study.points[i];
    if (point.wall_s > near_factor * least_wall) continue;
    if (!best || point.error < study.points[*best].error) best = i;
  }
  return best;
}

std::vector<std::string> sentences(const ErrorStudy& study) {
  std::vector<std::string> lines;
  say_targets(study, lines);
  for (const char* preset : {"modern", "paper"}) say_preset(study, preset, lines);
  say_failures(study, RunStatus::unstable, "Unstable", lines);
  say_failures(study, RunStatus::refused, "Not possible in this scene", lines);
  const auto reference = std::find_if(study.points.begin(), study.points.end(),
                                      [](const Point& point) { return point.reference; });
  if (reference != study.points.end()) {
    std::string line = "There is no closed form: errors are held against ";
    if (!study.reference) {
      line += fmt::format("{}, which has no result.", place(*reference));
    } else if (study.reference->order) {
      line += fmt::format(
          "what {} tends to at its three finest spacings (Richardson, order {:.2g}); at the "
          "finest, "
          "{:g} m, it is still off by {}.",
          reference->setting, *study.reference->order, reference->spacing,
          percent(reference->error));
    } else {
      line += fmt::format("{}, whose own error these runs do not tell.", place(*reference));
    }
    lines.push_back(line);
  }
  if (study.left_out > 0) {
    lines.push_back(
        fmt::format("The budget left no time for {} runs; the same command again does "
                    "them.",
                    study.left_out));
  }
  return lines;
}

}  // namespace scarp::validation
