// SPDX-License-Identifier: BSD-3-Clause
/// The loop of a run: where it ends, whom it calls, what it leaves when it is stopped.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "engine/errors.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/run/checkpoint_writer.hpp"
#include "engine/run/run.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

namespace fs = std::filesystem;

Scene two_stages() {
  Scene scene = elastic_column("modern", 1.0, 0.1);
  scene.stages = {stage_for("first", 0.004), stage_for("second", 0.004)};
  return scene;
}

TEST(RunLoopTest, StepsToTheEndOfTheLastStageWithoutAnyPart) {
  Simulation simulation(two_stages(), {1, {}});
  EXPECT_GE(run(simulation), 0.0);
  EXPECT_TRUE(simulation.finished());
  EXPECT_DOUBLE_EQ(simulation.last_step().time, total_duration(simulation.scene()));
}

TEST(RunLoopTest, EndsWhereTheCourseSaysAndGoesOnFromThere) {
  Simulation simulation(two_stages(), {1, {}});
  int calls = 0;
  const auto count = [&calls](const Simulation&) {
    ++calls;
    return true;
  };
  run(simulation,
      {.until = [](const Simulation& now) { return now.stage_ended(); }, .after_step = count});
  EXPECT_EQ(simulation.stage_index(), 0U);
  EXPECT_EQ(static_cast<std::uint64_t>(calls), simulation.last_step().step);
  run(simulation, {.after_step = count});
  EXPECT_TRUE(simulation.finished());
  EXPECT_EQ(static_cast<std::uint64_t>(calls), simulation.last_step().step);
}

TEST(RunLoopTest, AskedToStopItLeavesACheckpointOfTheLastStep) {
  const fs::path folder = fs::path(testing::TempDir()) / ("scarp_loop_" + std::to_string(getpid()));
  bool stop = false;
  Simulation simulation(two_stages(), {.threads = 1, .stop = [&stop] { return stop; }});
  RunWriter writer(simulation, folder);
  CheckpointWriter checkpoints(simulation, writer);
  const auto after_step = [&stop](const Simulation& now) {
    stop = now.last_step().step == 3;
    return true;
  };
  EXPECT_THROW(
      run(simulation, {.writer = &writer, .checkpoints = &checkpoints, .after_step = after_step}),
      Stopped);
  ASSERT_EQ(checkpoints_in(folder).size(), 1U);
  EXPECT_EQ(checkpoints_in(folder).front().filename(), "step_000000000003.h5");
  EXPECT_TRUE(fs::exists(folder / "results.json"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace scarp::test
