// SPDX-License-Identifier: BSD-3-Clause
/// Which settings are tried: one axis at a time around each preset, then what lies near the front.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "validation/error_time/pareto.hpp"
#include "validation/error_time/settings.hpp"

namespace scarp::validation {

/// The scene's own numerics under each preset.
using PresetNumerics = std::map<std::string, Numerics>;

struct PlanOptions {
  std::vector<std::string> axes;  ///< that vary; the others stay at `modern` and the third spacing
  bool short_form = false;        ///< two coarsest spacings, one choice of each axis
  bool against_finest = false;    ///< the problem has no error of its own
};

/// Finest of the spacings in use.
std::size_t finest_level(const PlanOptions& options);

/// The run that others are held against, if the problem has no error of its own.
std::optional<Trial> reference_trial(const PlanOptions& options);

/// Presets as they stand at all spacings, then with one choice changed at all but the finest. If
/// there is a reference, the finest spacing is its alone, and its setting is run at the three
/// finest whatever the axes.
std::vector<Trial> first_round(const PresetNumerics& presets, const PlanOptions& options);

struct TrialOutcome {
  Trial trial;
  ErrorTime at;
};

/// Neighbours of the changed settings that nothing beats by `near_factor`, not yet tried: two of
/// one preset and spacing that change different axes together, and those at the last spacing but
/// one at the finest one too.
std::vector<Trial> neighbour_round(const std::vector<TrialOutcome>& tried,
                                   const PlanOptions& options);

/// Twice what repeated runs of one setting scatter by on a machine in use.
inline constexpr double near_factor = 1.2;

}  // namespace scarp::validation
