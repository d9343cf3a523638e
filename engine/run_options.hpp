// SPDX-License-Identifier: BSD-3-Clause
/// How a run is carried out.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "engine/step/reduction.hpp"

namespace scarp {

/// How a run is carried out; nothing here changes the physics.
struct RunOptions {
  /// Exactly that many; empty: as many as pay at the moment, at most what OpenMP would take (see
  /// `Team`). Errors: SceneError if there are fewer cores, and below 1.
  std::optional<int> threads{};
  std::string isa{};  ///< see isa_names.hpp; empty: SCARP_ISA, else the best the machine has
  bool oversubscribe = false;  ///< allows up to 16 threads on fewer cores: slow, for tests
  /// Whether to stop: looked at before each step and within the set-up, by copies of a simulation
  /// too, in the thread that called. Cheap, and safe to call at any time; empty: never.
  std::function<bool()> stop = {};
  /// Joins the parts of a soil that several simulations hold; empty: one holds it all. Copies of a
  /// simulation share it.
  std::shared_ptr<Reduction> reduction = {};
};

}  // namespace scarp
