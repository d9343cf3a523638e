// SPDX-License-Identifier: BSD-3-Clause
/// When checkpoints fall due, whatever the clock does.
#include "engine/run/checkpoint_writer.hpp"

#include "tests/engine/output/output_fixture.hpp"

namespace scarp {
namespace {

class CheckpointWriterTest : public OutputTest {
 protected:
  using Clock = CheckpointWriter::Clock;

  /// Steps of the run after which a checkpoint was there that was not there before, while the clock
  /// moves by `seconds[n]` before step n.
  std::vector<std::size_t> steps_with_checkpoint(const std::string& schedule,
                                                 const std::vector<double>& seconds) {
    Simulation simulation(read_scene_text(block_text + schedule, "block.toml"));
    const std::filesystem::path folder = folder_ / std::to_string(runs_++);
    RunWriter outputs(simulation, folder);
    Clock::time_point now{};
    CheckpointWriter writer(simulation, outputs, [&now] { return now; });
    std::vector<std::size_t> found;
    std::filesystem::path newest;
    for (std::size_t n = 0; n < seconds.size(); ++n) {
      now += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds[n]));
      simulation.step();
      outputs.after_step(simulation);
      EXPECT_EQ(writer.after_step(simulation), "");
      const auto all = checkpoints_in(folder);
      EXPECT_LE(all.size(), 2u);
      if (all.empty() || all.front() == newest) continue;
      newest = all.front();
      found.push_back(n);
    }
    return found;
  }

 private:
  int runs_ = 0;
};

using Steps = std::vector<std::size_t>;

TEST_F(CheckpointWriterTest, ComesWhenTheIntervalByTheClockHasPassed) {
  const std::vector<double> even(10, 4.0);
  EXPECT_EQ(steps_with_checkpoint("[checkpoint]\nwall_every = \"12 s\"\n", even), (Steps{2, 5, 8}));
  EXPECT_EQ(steps_with_checkpoint("[checkpoint]\nwall_every = 0\n", even), Steps{});
}

TEST_F(CheckpointWriterTest, AClockThatLeapsAheadBringsOneCheckpoint) {
  const std::vector<double> suspended{1, 86400 * 365.0, 1, 1, 1, 10};
  EXPECT_EQ(steps_with_checkpoint("[checkpoint]\nwall_every = \"12 s\"\n", suspended),
            (Steps{1, 5}));
}

TEST_F(CheckpointWriterTest, AClockThatGoesBackDelaysAndDoesNoHarm) {
  const std::vector<double> back{12, -1000, 12, 500, 500, 12};
  EXPECT_EQ(steps_with_checkpoint("[checkpoint]\nwall_every = \"12 s\"\n", back), (Steps{0, 4, 5}));
}

TEST_F(CheckpointWriterTest, SimulatedTimeDoesNotAskTheClock) {
  const std::string by_time = "[checkpoint]\nevery = 1e-9\nwall_every = 0\n";
  EXPECT_EQ(steps_with_checkpoint(by_time, {0, -5, 1e6}), (Steps{0, 1, 2}));
}

}  // namespace
}  // namespace scarp
