// SPDX-License-Identifier: BSD-3-Clause
/// Fields seen without a copy and set from outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/errors.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// An elastic block that nothing acts on.
Scene free_block(const std::string& preset_name) {
  return {.gravity = {},
          .spacing = 0.1,
          .numerics = preset(preset_name),
          .materials = {elastic()},
          .bodies = {{.shape = Box{{0, 0, 0}, {1, 0.5, 0}}}},
          .stages = {stage_for("go", 1.0)}};
}

constexpr std::array<double, 6> pressed{-3e3, -3e3, -3e3, 0.0, 0.0, 0.0};

std::vector<double> stress_of(const Simulation& simulation) {
  std::vector<double> stress;
  for (std::size_t k = 0; k < simulation.soil_count(); ++k)
    stress.insert(stress.end(), pressed.begin(), pressed.end());
  return stress;
}

TEST(FieldsTest, AViewShowsWhatTheCopyHolds) {
  const Simulation simulation = run_steps(small_slope("modern", 1.0, 1.0, 1.0), 20, {1, {}});
  for (const char* name : {"position", "velocity", "stress", "density"}) {
    const std::vector<double> copy = simulation.field(name);
    const std::size_t per_particle = copy.size() / simulation.soil_count();
    const FieldView view = simulation.view(name);
    std::size_t seen = 0;
    for (std::size_t slot = 0; slot < view.ids.size(); ++slot) {
      if (view.ids[slot] < 0) continue;
      ++seen;
      for (std::size_t c = 0; c < view.components.size(); ++c) {
        ASSERT_EQ(view.components[c][slot],
                  copy[static_cast<std::size_t>(view.ids[slot]) * per_particle + c])
            << name;
      }
    }
    EXPECT_EQ(seen, simulation.soil_count());
  }
  EXPECT_THROW(static_cast<void>(simulation.view("displacement")),
               Error);  // computed when it is read
  EXPECT_THROW(static_cast<void>(simulation.view("build_position")), Error);
}

TEST(FieldsTest, AStressSetBeforeTheFirstStepIsThatOfTheScene) {
  for (const char* preset_name : {"modern", "paper"}) {
    Scene scene = free_block(preset_name);
    Simulation set(scene, {1, {}});
    set.set_field("stress", stress_of(set));
    scene.initial_stress = InitialStress::uniform;
    scene.uniform_stress = pressed;
    Simulation made(scene, {1, {}});
    for (int k = 0; k < 5; ++k) {
      set.step();
      made.step();
    }
    EXPECT_EQ(set.field("velocity"), made.field("velocity")) << preset_name;
    EXPECT_EQ(set.field("stress"), made.field("stress")) << preset_name;
  }
}

TEST(FieldsTest, WhatIsSetBetweenTwoStepsActsInTheNext) {
  for (const char* preset_name : {"modern", "paper"}) {
    Simulation made(free_block(preset_name), {1, {}});
    made.set_field("stress", stress_of(made));
    made.step();
    Simulation set = run_steps(free_block(preset_name), 1, {1, {}});  // at rest without stress
    set.set_field("stress", stress_of(set));
    set.step();
    ASSERT_EQ(set.last_step().time_step, made.last_step().time_step) << preset_name;
    const std::vector<double> wanted = made.field("velocity"), found = set.field("velocity");
    const double size = *std::max_element(wanted.begin(), wanted.end());
    ASSERT_GT(size, 0.0);
    // The same sums in the same order: Verlet's first step after a restart is one of Euler in both.
    for (std::size_t k = 0; k < wanted.size(); ++k)
      ASSERT_NEAR(found[k], wanted[k], 1e-12 * size) << preset_name;
  }
}

TEST(FieldsTest, ASpeedSetBetweenTwoStepsIsNoEnergyFromNothing) {
  for (const char* preset_name : {"modern", "paper"}) {
    Simulation simulation = run_steps(free_block(preset_name), 1, {1, {}});
    std::vector<double> velocity(3 * simulation.soil_count(), 0.0);
    for (std::size_t k = 0; k < velocity.size(); k += 3) velocity[k] = 5.0;
    simulation.set_field("velocity", velocity);
    const double from = simulation.last_step().time;
    for (int k = 0; k < 60; ++k) simulation.step();  // the watch looks every 50
    const double moved = 5.0 * (simulation.last_step().time - from);
    const std::vector<double> found = simulation.field("displacement");
    // Round-off of 60 sums of positions below 2 m.
    for (std::size_t k = 0; k < found.size(); k += 3) ASSERT_NEAR(found[k], moved, 1e-12);
  }
}

TEST(FieldsTest, RefusesWhatCannotBeSetAndChangesNothing) {
  Simulation simulation(free_block("modern"), {1, {}});
  const std::vector<double> before = simulation.field("velocity");
  std::vector<double> velocity(before.size(), 1.0);
  EXPECT_THROW(simulation.set_field("velocity", {velocity.data(), 3}), Error);
  velocity.back() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(simulation.set_field("velocity", velocity), Error);
  EXPECT_THROW(simulation.set_field("position", before), Error);
  EXPECT_THROW(simulation.set_field("displacement", before), Error);
  const std::vector<double> none(simulation.soil_count(), 0.0);
  EXPECT_THROW(simulation.set_field("density", none), Error);
  EXPECT_EQ(simulation.field("velocity"), before);
}

}  // namespace
}  // namespace scarp::test
