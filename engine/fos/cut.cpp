// SPDX-License-Identifier: BSD-3-Clause
/// Cuts of strength in steps of equal ratio.

#include "engine/fos/cut.hpp"

#include <algorithm>
#include <cmath>

namespace scarp {
namespace {

/// Steps from one factor to another, the last included; a rounding error is none.
int steps_between(double from, double to) {
  const double steps = cut_unit_steps * std::abs(std::log(to / from)) / std::log(cut_unit);
  return static_cast<int>(std::ceil(steps - 1e-9));
}

double after_steps(double from, double to, int steps) {
  if (steps >= steps_between(from, to)) return to;
  const double ratio = std::pow(cut_unit, static_cast<double>(steps) / cut_unit_steps);
  return to > from ? from * ratio : from / ratio;
}

}  // namespace

std::vector<StageStrength> cut_levels(const StageStrength& from, const StageStrength& to) {
  const auto start_of = [&from](const std::string& material) {
    const auto own = from.materials.find(material);
    return own != from.materials.end() ? own->second : from.all;
  };
  int steps = steps_between(from.all, to.all);
  for (const auto& [material, factor] : to.materials)
    steps = std::max(steps, steps_between(start_of(material), factor));
  std::vector<StageStrength> levels;
  for (int k = 1; k < steps; ++k) {
    StageStrength level{after_steps(from.all, to.all, k)};
    for (const auto& [material, factor] : to.materials)
      level.materials[material] = after_steps(start_of(material), factor, k);
    levels.push_back(level);
  }
  return levels;
}

}  // namespace scarp
