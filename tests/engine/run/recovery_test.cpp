// SPDX-License-Identifier: BSD-3-Clause
/// A run with a step too long goes back, halves it and comes to its end.
#include "engine/run/recovery.hpp"
#include "engine/run/run.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "engine/run/checkpoint_writer.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

namespace fs = std::filesystem;

/// Verlet from 0.6 of a second on with a step that it does not stand.
Scene reckless(int retries) {
  Scene scene = elastic_column("modern", 2.0, 0.1);
  scene.numerics.integrator = Integrator::verlet;
  scene.numerics.cfl = 1.5;
  scene.stages = {stage_for("load", 0.5)};
  scene.retries = retries;
  scene.output.probe_interval = 0.01;
  return scene;
}

class RecoveryTest : public ::testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  // Tests run side by side, each in a process of its own.
  const fs::path folder_ =
      fs::path(::testing::TempDir()) / ("scarp_recovery_" + std::to_string(getpid()));
};

TEST_F(RecoveryTest, HalvesUntilTheRunIsStableAndSaysSo) {
  Simulation simulation(reckless(5), {1, {}});
  RunWriter writer(simulation, folder_);
  Recovery recovery(simulation, writer);
  int unstable = 0;
  const auto warn = [&unstable](const std::string& words) {
    ++unstable;
    EXPECT_NE(words.find("Retry"), std::string::npos);
  };
  run(simulation, {.writer = &writer, .recovery = &recovery, .warn = warn});
  ASSERT_GE(unstable, 1);
  ASSERT_EQ(writer.retries().size(), static_cast<std::size_t>(unstable));
  EXPECT_EQ(writer.retries().back().step_factor, simulation.step_factor());
  EXPECT_LT(writer.retries().back().back_to, writer.retries().back().step);
  EXPECT_LE(simulation.step_factor(), 0.5);

  // From the start with the step it ended with: the same bits, if it went back to the start.
  if (writer.retries().back().back_to == 0) {
    Simulation fresh(reckless(5), {1, {}});
    fresh.set_step_factor(simulation.step_factor());
    while (!fresh.finished()) fresh.step();
    EXPECT_EQ(fresh.field("stress"), simulation.field("stress"));
    EXPECT_EQ(fresh.last_step().step, simulation.last_step().step);
  }
  // A snapshot carries the factor: what goes on from it goes on alike.
  Simulation half(reckless(5), {1, {}});
  half.set_step_factor(0.25);
  for (int k = 0; k < 50; ++k) half.step();
  Simulation resumed(reckless(5), half.snapshot(), {1, {}});
  for (int k = 0; k < 50; ++k) {
    half.step();
    resumed.step();
  }
  EXPECT_EQ(half.field("position"), resumed.field("position"));
}

TEST_F(RecoveryTest, GivesUpWhenNoRetryIsLeft) {
  Simulation simulation(reckless(0), {1, {}});
  RunWriter writer(simulation, folder_);
  Recovery recovery(simulation, writer);
  try {
    run(simulation, {.writer = &writer});
    FAIL() << "ran on";
  } catch (const SimulationInstability& instability) {
    EXPECT_FALSE(recovery.go_back(simulation, writer, instability));
  }
}

TEST_F(RecoveryTest, CheckpointsAfterTheStateGoneBackToAreRemoved) {
  Simulation simulation(elastic_column("modern", 1.0, 0.1), {1, {}});
  RunWriter writer(simulation, folder_);
  CheckpointWriter checkpoints(simulation, writer);
  for (int k = 0; k < 3; ++k) {
    simulation.step();
    checkpoints.write(simulation);
  }
  ASSERT_EQ(checkpoints_in(folder_).size(), 2u);
  remove_checkpoints_after(folder_, 2);
  ASSERT_EQ(checkpoints_in(folder_).size(), 1u);
  EXPECT_EQ(checkpoints_in(folder_).front().filename(), "step_000000000002.h5");
}

}  // namespace
}  // namespace scarp::test
