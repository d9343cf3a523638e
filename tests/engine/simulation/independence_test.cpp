// SPDX-License-Identifier: BSD-3-Clause
/// Several simulations in one process know nothing of each other, and an error leaves what was
/// there as it was.
#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

#include "engine/errors.hpp"
#include "engine/scene/scene_reader.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// Everything a program can see of a run but its wall times.
struct Sight {
  std::uint64_t step;
  double time;
  std::vector<std::vector<double>> fields;
  EnergyBalance energy;
  bool operator==(const Sight& other) const {
    return step == other.step && time == other.time && fields == other.fields &&
           energy.kinetic == other.energy.kinetic && energy.elastic == other.energy.elastic &&
           energy.plastic == other.energy.plastic;
  }
};

Sight sight_of(const Simulation& simulation) {
  Sight sight{simulation.last_step().step,
              simulation.last_step().time,
              {simulation.field("position")},
              simulation.energy()};
  for (const FieldInfo& info : simulation.fields()) {
    sight.fields.push_back(simulation.field(info.name));
  }
  return sight;
}

/// Two runs that share as little as can be: dimension, preset, integrator, walls that go.
Scene slope() { return small_slope("modern", 0.02, 10.0, 1.8); }
Scene collapse() { return small_collapse("paper", 0.02, 10.0); }
constexpr int steps = 80;

Sight alone(const Scene& scene) { return sight_of(run_steps(scene, steps, {1, {}})); }

/// Thrown so fast that the squares of its velocities are no numbers.
Scene doomed() {
  Scene scene = slope();
  scene.bodies[0].velocity_field = {"1e200 * x", "0"};
  return scene;
}

/// Steps until the run becomes unstable; how often it could.
int steps_to_failure(Simulation& simulation) {
  for (int k = 0; k < 10; ++k) {
    try {
      simulation.step();
    } catch (const SimulationInstability&) {
      return k;
    }
  }
  return -1;
}

TEST(IndependenceTest, RunsThatTakeTurnsGiveTheBitsOfEachAlone) {
  Simulation one(slope(), {1, {}}), two(collapse(), {1, {}});
  for (int k = 0; k < steps; ++k) {
    one.step();
    two.step();
  }
  EXPECT_EQ(sight_of(one), alone(slope()));
  EXPECT_EQ(sight_of(two), alone(collapse()));
}

TEST(IndependenceTest, RunsInTwoThreadsGiveTheBitsOfEachAlone) {
  std::vector<Scene> scenes{slope(), collapse(), slope()};
  std::vector<Sight> seen(scenes.size());
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    threads.emplace_back([&, k] {
      const int inner = k == 2 ? 2 : 1;  // one of them starts threads of its own
      seen[k] = sight_of(run_steps(scenes[k], steps, {inner, {}, true}));
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(seen[0], alone(slope()));
  EXPECT_EQ(seen[1], alone(collapse()));
  EXPECT_EQ(seen[2], seen[0]);
}

TEST(IndependenceTest, AFailedRunStaysReadableAndLeavesOthersAlone) {
  Simulation healthy(slope(), {1, {}}), failing(doomed(), {1, {}});
  for (int k = 0; k < steps / 2; ++k) healthy.step();
  ASSERT_GE(steps_to_failure(failing), 0);
  EXPECT_EQ(failing.field("position").size(), 3 * failing.soil_count());
  EXPECT_NO_THROW(static_cast<void>(failing.snapshot()));
  EXPECT_GE(steps_to_failure(failing), 0);  // it cannot be talked into going on
  for (int k = steps / 2; k < steps; ++k) healthy.step();
  EXPECT_EQ(sight_of(healthy), alone(slope()));
}

TEST(IndependenceTest, ABadSceneLeavesTheRunThatWasThere) {
  Simulation simulation(slope(), {1, {}});
  for (int k = 0; k < steps / 2; ++k) simulation.step();
  std::vector<Scene> bad(3, slope());
  bad[0].spacing = -1.0;                       // refused by the rules
  bad[1].spacing = 1e-6;                       // ... by the memory of the machine
  bad[2].walls[0].facets[0].normal[1] = -1.0;  // ... once the particles are there
  for (const Scene& scene : bad) {
    EXPECT_THROW(simulation = Simulation(scene), SceneError);
    EXPECT_THROW(simulation = Simulation(scene, simulation.snapshot()), Error);
  }
  Scene other = slope();
  other.numerics.cfl = 0.5;
  EXPECT_THROW(simulation = Simulation(other, simulation.snapshot()), CheckpointError);
  EXPECT_THROW(static_cast<void>(simulation.field("colour")), Error);
  Stage nameless = stage_for("", 1.0);
  EXPECT_THROW(simulation.set_following_stages({nameless}), SceneError);
  EXPECT_EQ(simulation.scene().stages.size(), 2u);
  for (int k = steps / 2; k < steps; ++k) simulation.step();
  EXPECT_EQ(sight_of(simulation), alone(slope()));
}

TEST(IndependenceTest, AFinishedRunSaysSoAndStaysAsItIs) {
  Scene scene = slope();
  for (Stage& stage : scene.stages) stage.duration = 0.001;
  Simulation simulation(scene, {1, {}});
  while (!simulation.finished()) simulation.step();
  const Sight before = sight_of(simulation);
  EXPECT_THROW(simulation.step(), Error);
  EXPECT_EQ(sight_of(simulation), before);
}

/// Reactions are summed over records of their own, in both precisions: nobody else notices.
TEST(IndependenceTest, ForcesOnWallsMayBeAskedForByTwoThreads) {
  for (const Precision precision : {Precision::real64, Precision::mixed}) {
    Scene scene = slope();
    scene.numerics.precision = precision;
    Simulation simulation(scene, {1, {}});
    for (int k = 0; k < steps / 2; ++k) simulation.step();
    const Simulation& asked = simulation;
    const auto forces = [&asked] {
      std::vector<Vec3> all;
      for (const WallReaction& reaction : asked.wall_reactions()) all.push_back(reaction.force);
      return all;
    };
    const std::vector<Vec3> alone = forces();
    std::vector<Vec3> other;
    std::thread thread([&] { other = forces(); });
    const std::vector<Vec3> own = forces();
    thread.join();
    EXPECT_EQ(own, alone);
    EXPECT_EQ(other, alone);
    EXPECT_LT(alone[0][1], 0.0);  // the base carries the slope
  }
}

}  // namespace
}  // namespace scarp::test
