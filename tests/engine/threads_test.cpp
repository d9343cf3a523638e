// SPDX-License-Identifier: BSD-3-Clause
/// The number of threads changes nothing; under the thread sanitizer, nothing is shared unguarded.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <new>
#include <stdexcept>
#include <variant>
#include <vector>

#include "engine/errors.hpp"
#include "engine/parallel.hpp"
#include "engine/particles/aligned_vector.hpp"
#include "engine/simulation.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp {
namespace {

/// A block thrown sideways onto a wall: about 4000 particles, so several chunks of every parallel
/// loop, and fast enough that the neighbour lists are rebuilt on the way.
Scene thrown_block() {
  Scene scene;
  scene.spacing = 0.05;
  Material clay{"clay", DruckerPrager{10e6, 0.3, 10e3, 0.35, 0.0, Cone::plane_strain}, 2000.0};
  scene.materials = {clay};
  Body block;
  block.shape = Polygon{{{1.0, 0.0}, {6.0, 0.0}, {6.0, 2.0}, {1.0, 2.0}}};
  block.velocity = {3.0, 0.0, 0.0};
  scene.bodies = {block};
  Wall base;
  base.name = "base";
  base.facets = {{{}, {1.0, 0.0, 0.0}, {}, 9.0, 0.0, {0.0, 1.0, 0.0}}};
  scene.walls = {base};
  Stage slide;
  slide.name = "slide";
  slide.duration = 10.0;
  scene.stages = {slide};
  scene.output.energy = true;  // its sums must not depend on the threads either
  return scene;
}

struct Outcome {
  double time;
  std::vector<double> position, velocity, stress;
  double plastic_work, viscous_work;
};

Outcome run(int threads) {
  RunOptions options;
  options.threads = threads;
  options.oversubscribe = true;
  Simulation simulation(thrown_block(), options);
  EXPECT_EQ(simulation.threads(), threads);
  for (int step = 0; step < 60; ++step) simulation.step();
  const EnergyBalance energy = simulation.energy();
  return {simulation.last_step().time,
          simulation.field("position"),
          simulation.field("velocity"),
          simulation.field("stress"),
          energy.plastic,
          energy.viscous};
}

// Equal to the last bit: chunks and the order of every sum are the same for any number of threads.
TEST(SimulationThreadsTest, GiveTheSameBitsForAnyNumber) {
  const Outcome one = run(1);
  ASSERT_GT(one.position.size(), 3u * 3000u);
  for (const int threads : {2, 3, 8}) {
    const Outcome more = run(threads);
    EXPECT_EQ(one.time, more.time);
    EXPECT_EQ(one.position, more.position);
    EXPECT_EQ(one.velocity, more.velocity);
    EXPECT_EQ(one.stress, more.stress);
    EXPECT_EQ(one.plastic_work, more.plastic_work);
    EXPECT_EQ(one.viscous_work, more.viscous_work);
  }
}

/// Two soils that fall into a corner of smooth planes, which mirror more than a chunk of them, on a
/// rough base that moves; the lists are built every few steps, with and without a sort.
Scene falling_corner() {
  Scene scene = test::small_collapse("modern", 0.0125, 10.0);
  scene.materials.push_back(scene.materials[0]);
  scene.materials[1].name = "stiff sand";
  scene.materials[1].model = DruckerPrager{4e6, 0.25, 0.0, 0.576, 0.0, Cone::outer};
  scene.bodies.push_back(scene.bodies[0]);
  for (std::size_t k = 0; k < 2; ++k) scene.bodies[k].material = scene.materials[k].name;
  std::get<Box>(scene.bodies[0].shape).maximum[2] = 0.08;
  std::get<Box>(scene.bodies[1].shape).minimum[2] = 0.08;
  for (Body& body : scene.bodies) body.velocity = {-2.0, 1.0, -2.0};
  scene.walls[0].velocity = {0.2, 0.0, 0.0};
  scene.output.energy = true;
  return scene;
}

TEST(SimulationThreadsTest, GiveTheSameBitsWhereSoilIsMirroredAndWallsMove) {
  const auto outcome = [](int threads) {
    const Simulation simulation =
        test::run_steps(falling_corner(), 32, {.threads = threads, .oversubscribe = true});
    EXPECT_GT(simulation.rebuild_count(), 4u);  // the fifth does not sort
    const EnergyBalance energy = simulation.energy();
    std::vector<double> all = simulation.field("position");
    for (const char* field : {"velocity", "stress"}) {
      const std::vector<double> values = simulation.field(field);
      all.insert(all.end(), values.begin(), values.end());
    }
    all.insert(all.end(), {simulation.last_step().time, energy.kinetic, energy.elastic,
                           energy.viscous, energy.wall});
    return all;
  };
  const std::vector<double> one = outcome(1);
  for (const int threads : {2, 8}) EXPECT_EQ(outcome(threads), one) << threads;
}

TEST(PutBehindEachOtherTest, SizesBecomePlaces) {
  std::vector<int> sizes{3, 0, 5, 1};
  EXPECT_EQ(put_behind_each_other(sizes), 9);
  EXPECT_EQ(sizes, (std::vector<int>{0, 3, 3, 8}));
  sizes.clear();
  EXPECT_EQ(put_behind_each_other(sizes), 0);
}

TEST(ParallelGatherTest, KeepsTheOrderOfTheChunks) {
  // Of k as many as its last digit, so that chunks have sizes of their own and one of ten has none.
  const auto append = [](std::int64_t begin, std::int64_t end, auto& out) {
    for (std::int64_t k = begin; k < end; ++k) {
      for (std::int64_t n = 0; n < k % 10; ++n) out.push_back(k);
    }
  };
  for (const std::int64_t count : {0, 1, 6, 7, 8, 1000}) {
    std::vector<std::int64_t> wanted;
    append(0, count, wanted);
    for (const std::int64_t chunk : {1, 7, 2000}) {
      for (const int threads : {1, 2, 4, 8}) {
        std::vector<std::int64_t> filled(3, -1);
        parallel_gather(threads, count, chunk, filled, append);
        EXPECT_EQ(filled, wanted) << count << " " << chunk << " " << threads;
        RawVector<std::int64_t> raw(5);
        parallel_gather(threads, count, chunk, raw, append);
        EXPECT_TRUE(std::equal(raw.begin(), raw.end(), wanted.begin(), wanted.end()));
      }
    }
  }
}

TEST(ParallelGatherTest, HandsOnWhatAChunkThrows) {
  std::vector<int> all;
  EXPECT_THROW(parallel_gather(3, 1000, 10, all,
                               [](std::int64_t begin, std::int64_t, std::vector<int>&) {
                                 if (begin == 500) throw std::bad_alloc();
                               }),
               std::bad_alloc);
}

TEST(ParallelChunksTest, HandOnWhatAChunkThrows) {
  for (const int threads : {1, 2, 3}) {
    std::atomic<int> done = 0;
    const auto work = [&](std::int64_t begin, std::int64_t) {
      if (begin == 50) throw std::bad_alloc();
      ++done;
    };
    EXPECT_THROW(parallel_chunks(threads, 1000, 10, work), std::bad_alloc);
    EXPECT_LT(done, 100);
    // What comes after is not marked by it.
    done = 0;
    parallel_chunks(threads, 1000, 10, [&](std::int64_t, std::int64_t) { ++done; });
    EXPECT_EQ(done, 100);
  }
}

TEST(ParallelChunksTest, EveryChunkMayThrow) {
  const auto fail = [](std::int64_t, std::int64_t) -> int { throw std::length_error("all"); };
  const auto merge = [](int& total, int part) { total += part; };
  EXPECT_THROW(parallel_reduce(3, 1000, 1, 0, fail, merge), std::length_error);
}

TEST(StopTest, ComesBetweenTwoStepsAndTheRunCanGoOn) {
  int asked = 0, stop_at = 5;
  RunOptions options;
  options.threads = 1;
  Simulation undisturbed(thrown_block(), options);
  for (int step = 0; step < 6; ++step) undisturbed.step();
  RunOptions stopping = options;
  stopping.stop = [&] { return stop_at == asked; };
  Simulation simulation(thrown_block(), stopping);
  EXPECT_THROW(for (int step = 0; step < 100; ++step, ++asked) simulation.step(), Stopped);
  EXPECT_EQ(simulation.last_step().step, 5u);
  stop_at = -1;
  simulation.step();
  EXPECT_EQ(simulation.field("position"), undisturbed.field("position"));
  stop_at = asked;
  Simulation copy = simulation.clone();
  EXPECT_THROW(copy.step(), Stopped);
}

TEST(StopTest, ReachesTheSetUp) {
  RunOptions options;
  int looks = 0;
  options.stop = [&looks] { return ++looks == 40; };
  EXPECT_THROW(Simulation(thrown_block(), options), Stopped);
  EXPECT_EQ(looks, 40);
}

}  // namespace
}  // namespace scarp
