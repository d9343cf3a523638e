// SPDX-License-Identifier: BSD-3-Clause
/// The axes that `scarp-validate error-time` sweeps, and a setting as a preset with changes.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp::validation {

/// One value of an axis.
struct Choice {
  std::string_view name;
  void (*apply)(Numerics&);
};

/// One thing that can be chosen apart from the others.
struct Axis {
  std::string_view name;
  std::vector<Choice> choices;
};

/// Axes that change the numerics; spacing and preset are axes too, but no rows here.
const std::vector<Axis>& numerics_axes();

/// All axes by name: spacing, preset, then those of the numerics.
std::vector<std::string> axis_names();

/// The axes of `--axis`, which may hold commas; all of them if none is named. Errors: Error naming
/// what exists.
std::vector<std::string> parse_axes(const std::vector<std::string>& given);

/// A preset with some of its numerics changed.
struct Setting {
  std::string preset;
  std::map<std::size_t, std::size_t> changes;  ///< index of a numerics axis to index of its choice

  auto operator<=>(const Setting&) const = default;
  bool operator==(const Setting&) const = default;
};

/// A setting at one of the problem's spacings.
struct Trial {
  Setting setting;
  std::size_t level = 0;  ///< index into the problem's spacings, 0 the coarsest

  auto operator<=>(const Trial&) const = default;
  bool operator==(const Trial&) const = default;
};

/// "modern", "modern with verlet CFL 0.3 and stress_diffusion 0".
std::string name_of(const Setting& setting);

/// The scene's numerics for the preset, changed as the setting says.
Numerics numerics_of(const Setting& setting, Numerics of_preset);

/// Every row of the numerics as text: equal texts compute the same.
std::string numerics_text(const Numerics& numerics);

}  // namespace scarp::validation
