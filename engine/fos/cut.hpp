// SPDX-License-Identifier: BSD-3-Clause
/// The way from one strength to another.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// Factors on the strength, as a stage has them.
struct StageStrength {
  double all = 1.0;
  std::map<std::string, double> materials{};  ///< overrides by name
  bool operator==(const StageStrength&) const = default;
};

inline StageStrength strength_of(const Stage& stage) {
  return {stage.strength_reduction, stage.material_strength_reduction};
}
inline void set_strength(Stage& stage, const StageStrength& strength) {
  stage.strength_reduction = strength.all;
  stage.material_strength_reduction = strength.materials;
}

/// A cut by `cut_unit` takes so many steps of equal ratio; each sets free a hundredth of the energy
/// that the whole cut at once would.
inline constexpr int cut_unit_steps = 10;
inline constexpr double cut_unit = 1.5;

/// The strengths between two, both left out: every factor goes on by the same ratio each time until
/// it has reached its end. Cuts from the same state share their way as far as the smaller goes.
std::vector<StageStrength> cut_levels(const StageStrength& from, const StageStrength& to);

}  // namespace scarp
