// SPDX-License-Identifier: BSD-3-Clause
/// What is asked of the faces of walls: which are near, where they nearly meet, what lies behind.
#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "engine/boundary/dummies.hpp"
#include "engine/boundary/face_grid.hpp"
#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/wall_clearance.hpp"
#include "engine/boundary/wall_joints.hpp"
#include "engine/check/wall_gaps.hpp"
#include "engine/errors.hpp"
#include "tests/engine/boundary/line_walls.hpp"

namespace scarp::test {
namespace {

TEST(FaceGridTest, WithoutSitesHoldsNoPlace) {
  EXPECT_FALSE(FaceGrid().holds({0.0, 0.0, 0.0}, 1e-6));
}

TEST(NarrowGapsTest, WallsAreLengthenedToMeet) {
  Scene scene = empty_scene(2);
  const auto joined = [&](const Points2& base, const Points2& side) {
    scene.walls = {line_wall("base", WallKind::no_slip, base),
                   line_wall("side", WallKind::free_slip, side)};
    Scene closed = scene;
    close_narrow_gaps(closed);
    return std::pair{closed.walls[0].facets[0], closed.walls[1].facets[0]};
  };
  // The base is 0.3 m short of a side that goes on below.
  auto [base, side] = joined({{0.3, 0}, {10, 0}}, {{0, 5}, {0, -5}});
  EXPECT_NEAR(base.origin[0], 0.0, 1e-12);
  EXPECT_NEAR(base.length_u, 10.0, 1e-12);
  EXPECT_EQ(side.length_u, 10.0);
  // Both are short of the corner.
  std::tie(base, side) = joined({{0.3, 0}, {10, 0}}, {{0, 5}, {0, 0.3}});
  EXPECT_NEAR(base.origin[0], 0.0, 1e-12);
  EXPECT_NEAR(side.length_u, 5.0, 1e-12);
  // An inclined side is met where the base goes straight on.
  std::tie(base, side) = joined({{0.3, 0}, {10, 0}}, {{5, 5}, {-5, -5}});
  EXPECT_NEAR(base.origin[0], 0.0, 1e-12);
  // A spacing is wide enough for a grain; a touch is no gap.
  EXPECT_EQ(joined({{0.5, 0}, {10, 0}}, {{0, 5}, {0, -5}}).first.length_u, 9.5);
  EXPECT_EQ(joined({{0, 0}, {10, 0}}, {{0, 5}, {0, 0}}).first.length_u, 10.0);
}

TEST(NarrowGapsTest, AWallThatSlidesPastAnotherIsLengthenedToMeetItThere) {
  Scene scene = empty_scene(2);
  const auto length = [&](const Points2& moving, const Vec3& velocity) {
    scene.walls = {line_wall("plate", WallKind::no_slip, moving),
                   line_wall("side", WallKind::free_slip, {{0, 5}, {0, -5}})};
    scene.walls[0].velocity = velocity;
    Scene closed = scene;
    close_narrow_gaps(closed);
    return closed.walls[0].facets[0].length_u;
  };
  // A plate high above comes down past the side, 0.3 m beside it.
  EXPECT_NEAR(length({{9, 8}, {0.3, 8}}, {0, -0.1, 0}), 9.0, 1e-12);
  // It goes up, or stands, or is a spacing away.
  EXPECT_NEAR(length({{9, 8}, {0.3, 8}}, {0, 0.1, 0}), 8.7, 1e-12);
  EXPECT_NEAR(length({{9, 8}, {0.3, 8}}, {}), 8.7, 1e-12);
  EXPECT_NEAR(length({{9, 8}, {0.5, 8}}, {0, -0.1, 0}), 8.5, 1e-12);
  // A gate that is lifted off the side, which it touches, keeps its length.
  EXPECT_NEAR(length({{5, 0}, {0, 0}}, {0.1, 0, 0}), 5.0, 1e-12);
}

TEST(NarrowGapsTest, BothWidthsAreTold) {
  Scene scene = empty_scene(2);
  scene.walls = {line_wall("base", WallKind::no_slip, {{0.3, 0}, {9, 0}}),
                 line_wall("sides", WallKind::free_slip, {{0, 5}, {0, -5}}),
                 line_wall("far", WallKind::free_slip, {{10, -5}, {10, 5}})};
  const std::vector<std::string> told = wall_gaps(scene);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_NE(told[0].find("wall 'base' at (0.3, 0) ends less than a spacing short"),
            std::string::npos);
  EXPECT_NE(told[0].find("lengthened by 0.3 m"), std::string::npos) << told[0];
  EXPECT_NE(told[1].find("1 m from wall 'far': soil can leak"), std::string::npos) << told[1];
}

TEST(WallClearanceTest, SoilBehindAReversedLineIsNamed) {
  Scene scene = line_scene({{10, 0}, {0, 0}});
  scene.bodies = {{.shape = Box{{0, 0, 0}, {10, 5, 0}}}};
  const Particles soil = generate_soil(scene);
  try {
    check_wall_clearance(scene, soil);
    FAIL() << "no error";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(
                  "key 'wall[0]' = 'wall': the soil particle at (0.25, 0.25) lies 0.25 m behind"),
              std::string::npos)
        << message;
    EXPECT_NE(message.find("Try to reverse the order"), std::string::npos) << message;
  }
  scene.walls[0].facets = line_facets({{0, 0}, {10, 0}});
  EXPECT_NO_THROW(check_wall_clearance(scene, soil));
}

TEST(WallClearanceTest, SoilOnBothSidesOfALineIsToldHowASheetPileIsDrawn) {
  for (const bool reversed : {false, true}) {
    Scene scene = reversed ? line_scene({{5, 4}, {5, 1}}) : line_scene({{5, 1}, {5, 4}});
    scene.bodies = {{.shape = Box{{0, 0, 0}, {10, 5, 0}}}};
    try {
      check_wall_clearance(scene, generate_soil(scene));
      FAIL() << "no error";
    } catch (const SceneError& error) {
      const std::string message = error.what();
      EXPECT_NE(message.find("a wall has soil on one side only"), std::string::npos) << message;
      EXPECT_NE(message.find("sheet pile as a slot of 1.5 m"), std::string::npos) << message;
      EXPECT_EQ(message.find("reverse"), std::string::npos) << message;
    }
  }
}

TEST(WallClearanceTest, SoilOnTheOtherSideOfAThinWallIsClear) {
  // A wall 1 m thick with a face on each side: thinner than its layers of 1.5 m.
  Scene scene = empty_scene(2);
  scene.walls = {line_wall("sheet", WallKind::no_slip, {{4, 0}, {4, 4}, {5, 4}, {5, 0}})};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {4, 4, 0}}}, {.shape = Box{{5, 0, 0}, {9, 4, 0}}}};
  const Particles soil = generate_soil(scene);
  EXPECT_NO_THROW(check_wall_clearance(scene, soil));
  const auto held = cells(generate_dummies(scene), 0.5);
  EXPECT_EQ(held.size(), 16U);
  for (const auto& [cell, count] : held) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(cell[0] == 8 || cell[0] == 9);
  }
}

}  // namespace
}  // namespace scarp::test
