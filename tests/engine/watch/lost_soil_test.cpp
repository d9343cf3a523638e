// SPDX-License-Identifier: BSD-3-Clause
/// Soil that falls out of a scene is counted, and only that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr double dx = 0.1;

Material sand() {
  return {"sand", DruckerPrager{1e6, 0.3, 0.0, 0.5, 0.0, Cone::plane_strain}, 1600.0};
}

/// Sand in a smooth box 1 m wide; the base has a hole of `spacings` in its middle.
Scene leaking_box(double spacings) {
  Scene scene = elastic_column("modern", 1.0, dx);
  scene.materials = {sand()};
  const double low = 0.5 - 0.5 * spacings * dx, high = 0.5 + 0.5 * spacings * dx;
  scene.walls = {wall_of("box", WallKind::free_slip,
                         {facet_2d(0, 0, low, 0), facet_2d(high, 0, 1, 0), facet_2d(1, 0, 1, 2),
                          facet_2d(0, 2, 0, 0)})};
  scene.stages = {stage_for("leak", 1.5)};
  return scene;
}

/// One grain, at rest or thrown.
Scene grain(const Vec3& at, const Vec3& velocity, std::vector<Facet> faces, double duration) {
  Scene scene;
  scene.spacing = dx;
  scene.numerics = preset("modern");
  scene.materials = {sand()};
  scene.bodies = {{.shape = Box{at, {at[0] + dx, at[1] + dx, 0}}, .velocity = velocity}};
  scene.walls = {wall_of("floor", WallKind::no_slip, std::move(faces))};
  scene.stages = {stage_for("fall", duration)};
  return scene;
}

Simulation to_the_end(Scene scene) {
  Simulation simulation(std::move(scene), {1, {}});
  while (!simulation.finished()) simulation.step();
  return simulation;
}

std::uint64_t lost_in(Scene scene) { return to_the_end(std::move(scene)).lost_soil().particles; }

TEST(LostSoilTest, GrainsThatFallThroughAHoleAreCounted) {
  for (const double spacings : {3.0, 6.0}) {
    const Simulation simulation = to_the_end(leaking_box(spacings));
    const std::vector<double> position = simulation.field("position"),
                              lost = simulation.field("lost");
    std::uint64_t below = 0, marked = 0;
    for (std::size_t id = 0; id < lost.size(); ++id) {
      const double y = position[3 * id + 1];
      marked += lost[id] != 0.0 ? 1U : 0U;
      // It fell by 2h = 0.24 m at least, the last look is 50 steps, here at most 0.1 s, ago.
      below += y < -1.0 ? 1U : 0U;
      if (y < -1.0) {
        EXPECT_EQ(lost[id], 1.0) << id << " at " << y;
      }
      if (y > 0.0) {
        EXPECT_EQ(lost[id], 0.0) << id << " at " << y;
      }
    }
    const LostSoil& report = simulation.lost_soil();
    EXPECT_GT(below, 0U);
    EXPECT_EQ(report.particles, marked);
    EXPECT_DOUBLE_EQ(report.mass, static_cast<double>(marked) * 1600.0 * dx * dx);
    EXPECT_EQ(report.stage, "leak");
    EXPECT_EQ(lost[static_cast<std::size_t>(report.first)], 1.0);
    EXPECT_LT(report.position[1], 0.0);
    EXPECT_NE(report.message(100).find(" of 100 particles"), std::string::npos);
  }
}

TEST(LostSoilTest, LostGrainsDoNotKeepTheRestFromRest) {
  Scene scene = leaking_box(0.0);
  // A grain of its own, below the base.
  scene.bodies.push_back({.shape = Box{{0.41, -0.49, 0}, {0.49, -0.41, 0}}});
  scene.stages[0].until = StageEnd::rest;
  scene.stages[0].duration = 20.0;
  scene.stages[0].damping = 20.0;
  const Simulation simulation = to_the_end(scene);
  EXPECT_TRUE(simulation.stage_reached_rest());
  EXPECT_EQ(simulation.lost_soil().particles, 1U);
  EXPECT_LT(simulation.last_step().max_velocity, 1e-3);
}

TEST(LostSoilTest, SoilBelowItsBaseAndSoilWithoutWallsAnyMoreAreLost) {
  Scene below = grain({0, -2.0, 0}, {}, {facet_2d(-5, 0, 5, 0)}, 1.0);
  EXPECT_EQ(lost_in(below), 1U);
  Scene removed = small_slope("modern", 0.02, 1.0, 1.0);
  for (Wall& wall : removed.walls) wall.removed_at = "fail";
  const Simulation simulation = to_the_end(removed);
  EXPECT_EQ(simulation.lost_soil().particles, simulation.soil_count());
  EXPECT_EQ(simulation.lost_soil().stage, "fail");
}

TEST(LostSoilTest, WhatLandsIsNotLost) {
  const Facet near = facet_2d(-1, 0, 1, 0), far = facet_2d(4, -1, 40, -1);
  // Over the hole between the two floors, at 8 m/s: 3 m take 0.4 s, the fall over 1 m 0.45 s.
  EXPECT_EQ(lost_in(grain({0.9, 0.05, 0}, {8, 0, 0}, {near, far}, 1.0)), 0U);
  EXPECT_EQ(lost_in(grain({0.9, 0.05, 0}, {2, 0, 0}, {near, far}, 1.5)), 1U);
  // Off a cliff of 20 m, and from far above.
  EXPECT_EQ(lost_in(grain({0.9, 0.05, 0}, {3, 0, 0}, {near, facet_2d(1, -20, 40, -20)}, 1.9)), 0U);
  EXPECT_EQ(lost_in(grain({0, 30, 0}, {}, {near}, 2.4)), 0U);
  // Thrown up and over the end of the floor: lost only once it is below.
  const Scene up = grain({0.9, 0.05, 0}, {2, 6, 0}, {near}, 1.2);
  EXPECT_EQ(lost_in(up), 0U);
}

TEST(LostSoilTest, WithoutWallsNothingIsLost) {
  Scene scene = grain({0, 0, 0}, {}, {}, 3.0);
  scene.walls.clear();
  EXPECT_EQ(lost_in(scene), 0U);
}

TEST(LostSoilTest, SoilThatHangsIsNotLost) {
  // A bar under a rough ceiling, let go: it stretches and swings; a soft one would tear.
  Scene scene = elastic_column("modern", 1.0, dx);
  scene.materials = {elastic()};
  scene.walls = {wall_of("ceiling", WallKind::no_slip, {facet_2d(2, 1, -1, 1)})};
  scene.stages = {stage_for("swing", 1.0)};
  EXPECT_EQ(lost_in(scene), 0U);
}

TEST(LostSoilTest, WithoutGravityWhatHasLeftTheWallsBackwardsIsLost) {
  const auto with = [](const Vec3& at, const Vec3& velocity) {
    Scene scene = grain(at, velocity, {facet_2d(0, 2, 0, 0), facet_2d(0, 0, 2, 0)}, 1.0);
    scene.gravity = {};
    return scene;
  };
  EXPECT_EQ(lost_in(with({-0.5, 1, 0}, {-1, 0, 0})), 1U);  // behind the left wall, and away
  EXPECT_EQ(lost_in(with({1, 1, 0}, {0, 4, 0})), 0U);      // out of the open side
  EXPECT_EQ(lost_in(with({1, 1, 0}, {0, 0, 0})), 0U);
}

TEST(LostSoilTest, ASnapshotHoldsWhatIsLost) {
  const Scene scene = leaking_box(3.0);
  Simulation whole(scene, {1, {}});
  while (whole.lost_soil().particles == 0) whole.step();
  Simulation resumed(scene, whole.snapshot(), {2, {}});
  EXPECT_EQ(resumed.field("lost"), whole.field("lost"));
  EXPECT_EQ(resumed.lost_soil().message(1), whole.lost_soil().message(1));
  while (!whole.finished()) whole.step();
  while (!resumed.finished()) resumed.step();
  EXPECT_EQ(resumed.field("position"), whole.field("position"));
  EXPECT_EQ(resumed.field("lost"), whole.field("lost"));
  EXPECT_EQ(resumed.lost_soil().mass, whole.lost_soil().mass);
}

}  // namespace
}  // namespace scarp::test
