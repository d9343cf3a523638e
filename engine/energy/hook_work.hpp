// SPDX-License-Identifier: BSD-3-Clause
/// Measures what a hook does to the soil.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "engine/particles/field_list.hpp"

namespace scarp {

struct State;

/// One call of a hook. What it changes of place, speed, stress or density is the difference of the
/// energies before and after; what it adds to the acceleration is a force that acts for the step:
/// sum m v . a dt, first order in the step. Hooks that change nothing of that cost nothing.
class HookMeter {
 public:
  /// `share` of the step for which a force that is set at this place acts.
  HookMeter(State& state, double share) : state_(state), share_(share) {}

  /// Before a field is handed out to be changed.
  void before_change(Field field);
  /// Enters what has changed in the ledger; after the call.
  void enter();

 private:
  using Vectors = std::array<std::vector<double>, 3>;
  Vectors copy(Field field) const;
  /// Largest change of a vector since the copy.
  double largest_change(Field field, const Vectors& before) const;
  double power_of_change(const Vectors& before) const;

  State& state_;
  double share_;
  std::optional<double> energy_;  ///< before
  std::optional<Vectors> velocity_, acceleration_;
};

}  // namespace scarp
