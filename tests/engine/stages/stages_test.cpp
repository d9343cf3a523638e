// SPDX-License-Identifier: BSD-3-Clause
/// What a stage takes from its soil: damping, and how long calm has to last.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr double dx = 0.1;

/// A stage that settles: until rest, and the fields are reset after.
Scene settling(std::vector<Body> bodies) {
  Scene scene = elastic_column("modern", 1.0, dx);
  scene.materials = {elastic(10e6), elastic(40e6)};
  scene.materials[1].name = "stiff";
  scene.bodies = std::move(bodies);
  Stage settle = stage_for("settle", 10.0);
  settle.until = StageEnd::rest;
  settle.reset_after = true;
  scene.stages = {settle};
  return scene;
}

Body layer(double low, double high, const char* material) {
  return {.shape = Box{{0, low, 0}, {1, high, 0}}, .material = material};
}

double of_first_step(const Scene& scene, const char* item) {
  return run_steps(scene, 1, {1, {}}).snapshot().numbers(item, 1).front();
}

struct Height {
  Scene scene;
  double metres, sound_speed;
};

/// Heights and the slowest wave in them: of one layer, of two, of the taller of two that stand more
/// than 2h apart.
std::vector<Height> heights() {
  const double slow = elastic(10e6).sound_speed(), fast = elastic(40e6).sound_speed();
  return {{settling({layer(0, 2, "elastic")}), 2.0, slow},
          {settling({layer(0, 2, "stiff")}), 2.0, fast},
          {settling({layer(0, 1, "stiff"), layer(1, 3, "elastic")}), 3.0, slow},
          {settling({layer(0, 1, "elastic"), layer(1, 3, "stiff")}), 3.0, slow},
          {settling({layer(0, 1.2, "elastic"), layer(2, 3, "elastic")}), 1.2, slow}};
}

/// The damping is the circular frequency pi c/(2 H) of a column's first mode, and calm has to last
/// for four passages of a wave.
TEST(StagesTest, SettlingIsDampedByItsFirstMode) {
  for (const Height& one : heights()) {
    const double passage = one.metres / one.sound_speed;
    EXPECT_NEAR(of_first_step(one.scene, "stage/damping") * passage, std::numbers::pi / 2, 1e-12);
    EXPECT_NEAR(of_first_step(one.scene, "stage/rest_window") / passage, 4.0, 1e-12);
  }
}

/// Without damping calm has to last for a free fall, sqrt(H/g); a stage that does not settle has
/// none of its own.
TEST(StagesTest, WithoutDampingCalmLastsForAFall) {
  for (Height one : heights()) {
    one.scene.stages[0].reset_after = false;
    EXPECT_EQ(of_first_step(one.scene, "stage/damping"), 0.0);
    EXPECT_NEAR(of_first_step(one.scene, "stage/rest_window"), std::sqrt(one.metres / 9.81), 1e-12);
  }
}

TEST(StagesTest, RestIsCalmForTheWholeWindow) {
  Scene scene = settling({layer(0, 2, "elastic")});
  scene.gravity = {};
  scene.initial_stress = InitialStress::zero;
  Simulation simulation(scene, {1, {}});
  while (!simulation.stage_ended()) simulation.step();
  EXPECT_TRUE(simulation.stage_reached_rest());
  const double window = 4.0 * 2.0 / elastic(10e6).sound_speed();
  // Calm counts from the end of the first step, and the stage ends with the first step beyond.
  const StepReport& last = simulation.last_step();
  EXPECT_GT(last.time, window);
  EXPECT_LT(last.time, window + 2.1 * last.time_step);
}

}  // namespace
}  // namespace scarp::test
