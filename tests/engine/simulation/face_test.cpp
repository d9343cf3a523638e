// SPDX-License-Identifier: BSD-3-Clause
/// No-slip faces hold off single grains and leave packed soil alone.
#include <gtest/gtest.h>

#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// One grain of soft sand above the middle of a floor, thrown down.
Scene thrown_grain(const std::string& preset_name, double speed) {
  Scene scene;
  scene.spacing = 0.1;
  scene.gravity = {0.0, -9.81, 0.0};
  scene.numerics = preset(preset_name);
  scene.materials = {{"sand", "drucker_prager", 2000.0, {1e6, 0.3, 0.0, 0.52, 0.0, 0.0}}};
  scene.bodies = {{0, Box{{0, 0.2, 0}, {0.1, 0.3, 0}}, {1.0, -speed, 0.0}}};
  scene.walls = {wall_of("floor", WallKind::no_slip, {facet_2d(-10, 0, 10, 0)})};
  scene.stages = {stage_for("fall", 2.0)};
  return scene;
}

TEST(FaceTest, HoldsOffAGrainThatIsThrownAtIt) {
  for (const char* preset_name : {"paper", "modern"}) {
    for (const double speed : {1.0, 10.0}) {
      Simulation simulation(thrown_grain(preset_name, speed));
      while (!simulation.finished()) {
        simulation.step();
        // A step takes it at most speed times h over the speed of sound (26 m/s) further than dx/4.
        ASSERT_GT(simulation.field("position")[1], -0.025) << preset_name << " " << speed;
      }
      EXPECT_GT(simulation.face_hold_count(), 0U) << preset_name << " " << speed;
    }
  }
}

TEST(FaceTest, LeavesPackedSoilAlone) {
  Scene scene = elastic_column("modern", 2.0, 0.1);
  for (Wall& wall : scene.walls) wall.kind = WallKind::no_slip;
  Simulation simulation(scene);
  while (!simulation.finished()) simulation.step();
  EXPECT_EQ(simulation.face_hold_count(), 0U);
}

}  // namespace
}  // namespace scarp::test
