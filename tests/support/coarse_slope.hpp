// SPDX-License-Identifier: BSD-3-Clause
/// A slope for the tests of factors of safety.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/errors.hpp"
#include "engine/fos/strength_reduction.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {

/// Ten spacings high; settles until rest.
inline Scene coarse_slope() {
  Scene scene = small_slope("modern", 4.0, 4.0, 1.4);
  Stage& settle = scene.stages.front();
  settle.until = StageEnd::rest;
  settle.damping.reset();
  return scene;
}

inline StrengthReduction settled_slope(const Scene& scene, const CriterionOptions& options = {}) {
  Simulation simulation(scene);
  EXPECT_TRUE(settle(simulation, {}));
  return {std::move(simulation), choose_criterion(scene, options)};
}

/// The message of the error, which must come.
template <class Action>
std::string message_of(Action&& action) {
  try {
    action();
  } catch (const SceneError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no SceneError";
  return {};
}

}  // namespace scarp::test
