// SPDX-License-Identifier: BSD-3-Clause
/// Runs in several threads of one program write their files at the same time.
#include <gtest/gtest.h>

#include <array>
#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "engine/errors.hpp"
#include "engine/output/checkpoint_file.hpp"
#include "engine/output/run_writer.hpp"
#include "tests/engine/output/output_fixture.hpp"

namespace scarp {
namespace {

class TwoThreadsTest : public OutputTest {
 protected:
  /// Frames at each step, and each step's state written and read again.
  static void run_and_keep(const std::filesystem::path& folder) {
    Simulation simulation(read_scene_text(block_text, "block.toml", {}), {.threads = 1});
    RunWriter writer(simulation, folder);
    for (int k = 0; k < 20 && !simulation.finished(); ++k) {
      simulation.step();
      writer.after_step(simulation);
      write_soil_frame(folder / "each.hdf", simulation, "each");
      write_checkpoint(folder / "state.h5", simulation.snapshot());
      const Simulation again(simulation.scene(), read_checkpoint(folder / "state.h5"));
      if (again.field("stress") != simulation.field("stress")) throw Error("another state");
    }
  }
};

TEST_F(TwoThreadsTest, CheckpointsAndFramesAreWholeAndRight) {
  constexpr std::size_t runs = 4;
  std::array<std::string, runs> failure;
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < runs; ++k) {
    threads.emplace_back([this, k, &failure] {
      try {
        run_and_keep(folder_ / std::to_string(k));
      } catch (const std::exception& error) {
        failure[k] = error.what();
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t k = 0; k < runs; ++k) {
    EXPECT_EQ(failure[k], "") << k;
    EXPECT_EQ(text_of(folder_ / std::to_string(k) / "each.hdf"), text_of(folder_ / "0/each.hdf"));
  }
}

TEST_F(TwoThreadsTest, AnItemThatIsShorterThanItsShapeIsRefused) {
  Snapshot snapshot;
  snapshot.add({"fields/short", "m", {3, 1000}, std::vector<double>(10)});
  EXPECT_THROW(write_checkpoint(folder_ / "short.h5", snapshot), FileError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "short.h5"));
}

}  // namespace
}  // namespace scarp
