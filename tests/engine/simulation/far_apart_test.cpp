// SPDX-License-Identifier: BSD-3-Clause
/// Bodies far from each other: they do as each alone, in a time that does not know the distance.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/errors.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr int across = 7;  ///< particles of a block, which is no multiple of a cluster

Body block_at(double x, double y, double z, int dimension, double size = across) {
  return {.shape = Box{{x, y, z}, {x + size, y + size, dimension == 2 ? 0.0 : z + size}}};
}

Scene blocks(int dimension, std::vector<Body> bodies) {
  Scene scene;
  scene.dimension = dimension;
  scene.gravity = dimension == 2 ? Vec3{0, -9.81, 0} : Vec3{0, 0, -9.81};
  scene.spacing = 1.0;
  scene.materials = {elastic()};
  scene.bodies = std::move(bodies);
  // The first alone moves, and so alone sets the time step.
  scene.bodies[0].velocity_field = {"0.1*sin(3*x)", "0.1*cos(2*y)"};
  if (dimension == 3) scene.bodies[0].velocity_field.emplace_back("0");
  scene.stages = {stage_for("fly", 10.0)};
  return scene;
}

/// With boxes of cells from one body to the other this does not end: 10^11 cells and more.
TEST(FarApartTest, TwoBodiesOnADiagonalDoAsOneAlone) {
  for (const int dimension : {2, 3}) {
    // The last is 7 10^6 cells away: its cells have the keys of others.
    for (const double away : {1e4, 1e5, 9e6}) {
      const double up = dimension == 3 ? away : 0.0;
      const Simulation alone = run_steps(blocks(dimension, {block_at(0, 0, 0, dimension)}), 3);
      const Simulation both = run_steps(
          blocks(dimension, {block_at(0, 0, 0, dimension), block_at(away, away, up, dimension)}),
          3);
      const std::vector<double> one = alone.field("velocity"), two = both.field("velocity");
      ASSERT_EQ(2 * one.size(), two.size());
      // Sums run in another order: a few units of the last place of speeds below 1 m/s.
      for (std::size_t k = 0; k < one.size(); ++k) ASSERT_NEAR(two[k], one[k], 1e-13) << away;
    }
  }
}

TEST(FarApartTest, GrainsThatScatterWidelyAreNoSlowerThanTheirNumber) {
  // Strays on a diagonal, each so far from the next that a box of cells holds 10^10.
  std::vector<Body> bodies{block_at(0, 0, 0, 2)};
  for (int k = 1; k <= 40; ++k) bodies.push_back(block_at(k * 1e5, k * 1e5, 0, 2, 1.0));
  const Simulation simulation = run_steps(blocks(2, bodies), 3);
  EXPECT_EQ(simulation.soil_count(), static_cast<std::size_t>(across * across + 40));
  EXPECT_EQ(simulation.last_step().step, 3u);
}

TEST(FarApartTest, MixedPrecisionStopsWhereItsPositionsEnd) {
  // 2048 h = 2457.6 m; two blocks 2440 m apart fly from each other.
  Scene scene = blocks(2, {block_at(0, 0, 0, 2), block_at(2440, 0, 0, 2)});
  for (Body& body : scene.bodies) body.velocity_field.clear();
  scene.bodies[1].velocity = {40.0, 0.0, 0.0};
  scene.numerics.precision = Precision::mixed;
  Simulation simulation(scene, {2, {}});
  try {
    while (!simulation.finished()) simulation.step();
    FAIL() << "no end";
  } catch (const SimulationInstability& error) {
    ASSERT_TRUE(error.what_happened());
    const Instability& what = *error.what_happened();
    EXPECT_EQ(what.field, "distance from other soil");
    // The furthest grain begins 2446 m from the first and is then found within a step.
    EXPECT_NEAR(what.value, 2457.6, 1.0);
    EXPECT_GE(what.value, what.limit);
    EXPECT_DOUBLE_EQ(what.limit, 2457.6);
    EXPECT_GE(what.particle, 0);
    EXPECT_NEAR(what.time, (2457.6 - 2446.0) / 40.0, 0.1);
    EXPECT_NE(what.advice.find("double"), std::string::npos);
  }
  EXPECT_GT(simulation.last_step().step, 1u);
  EXPECT_EQ(simulation.field("position").size(), 3 * simulation.soil_count());
}

}  // namespace
}  // namespace scarp::test
