// SPDX-License-Identifier: BSD-3-Clause
/// Walls through which soil acts, faces that lie in one place, and walls without room for dummies.
#include "engine/check/thin_walls.hpp"

#include <gtest/gtest.h>

#include <string>

#include "engine/boundary/wall_clearance.hpp"
#include "engine/check/warnings.hpp"
#include "engine/errors.hpp"
#include "engine/particles/generate.hpp"
#include "engine/scene/facets.hpp"
#include "engine/scene/scene_reader.hpp"
#include "tests/engine/boundary/line_walls.hpp"

namespace scarp::test {
namespace {

constexpr double dx = 0.5;  // and h = 1.5 dx

/// Soil on both sides of a slot, with a wall on each face.
Scene slot(double width, WallKind left, WallKind right) {
  Scene scene = empty_scene(2);
  scene.bodies = {{.shape = Box{{0, 0, 0}, {10, 5, 0}}},
                  {.shape = Box{{10 + width, 0, 0}, {20, 5, 0}}}};
  scene.walls = {line_wall("left", left, {{10, 0}, {10, 6}}),
                 line_wall("right", right, {{10 + width, 6}, {10 + width, 0}})};
  return scene;
}

std::vector<std::string> told(const Scene& scene) {
  return thin_walls(scene, generate_soil(scene).position);
}

TEST(ThinWallsTest, RoughSlotsNeedTheSupportAndSmoothOnesTwice) {
  using enum WallKind;
  for (const auto& [left, right, enough] : {std::tuple{no_slip, no_slip, 3.0},
                                            {free_slip, no_slip, 6.0},
                                            {no_slip, free_slip, 6.0},
                                            {free_slip, free_slip, 6.0}}) {
    EXPECT_TRUE(told(slot(enough * dx, left, right)).empty());
    const std::vector<std::string> found = told(slot((enough - 1.0) * dx, left, right));
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].find("walls 'left' and 'right' stand back to back"), std::string::npos);
    EXPECT_NE(found[0].find("at (10, "), std::string::npos) << found[0];
  }
  const std::string message = told(slot(1.0, no_slip, no_slip)).at(0);
  EXPECT_NE(message.find("1 m apart"), std::string::npos) << message;
  EXPECT_NE(message.find("thinner than 1.5 m (2h)"), std::string::npos) << message;
  EXPECT_NE(message.find("a spacing of 0.33 m"), std::string::npos) << message;
}

TEST(ThinWallsTest, AirBehindAWallAndTheCornersOfARoomAreNoSoil) {
  using enum WallKind;
  Scene scene = slot(0.5, no_slip, free_slip);
  scene.bodies.pop_back();
  EXPECT_TRUE(told(scene).empty());
  scene.walls = {line_wall("room", free_slip, {{0, 6}, {0, 0}, {10, 0}, {10, 6}})};
  EXPECT_TRUE(told(scene).empty());
}

TEST(DoubledWallsTest, ASmoothFaceInThePlaceOfAnotherIsTold) {
  using enum WallKind;
  for (const WallKind base : {no_slip, free_slip}) {
    Scene scene = empty_scene(2);
    scene.bodies = {{.shape = Box{{0, 0, 0}, {10, 5, 0}}}};
    scene.walls = {line_wall("base", base, {{0, 0}, {10, 0}}),
                   line_wall("sides", free_slip, {{0, 6}, {0, 0}, {10, 0}, {10, 6}})};
    const std::vector<std::string> found = doubled_walls(scene);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found[0].find("walls 'base' and 'sides' have faces in one place"), std::string::npos);
    // They may meet at their ends, and rough faces share their dummies.
    scene.walls[1] = line_wall("goes on", free_slip, {{10, 0}, {20, 0}, {20, 6}});
    EXPECT_TRUE(doubled_walls(scene).empty());
    scene.walls[1] = line_wall("again", no_slip, {{0, 0}, {10, 0}});
    EXPECT_EQ(doubled_walls(scene).empty(), base == no_slip);
  }
}

TEST(DoubledWallsTest, ABoxThatForgotsAnOpenFaceIsToldIn3D) {
  Scene scene = read_scene_text(R"(
dimension = 3
spacing = 0.5
material = [{name = "s", density = 2000, youngs_modulus = "10 MPa", poisson_ratio = 0.3, cohesion = "5 kPa", friction_angle = "30 deg"}]
body = [{material = "s", box = {min = [0, 0, 0], max = [5, 5, 3]}}]
wall = [{name = "base", kind = "no_slip", rectangle = {origin = [0, 0, 0], u = [5, 0, 0], v = [0, 5, 0]}},
        {name = "sides", kind = "free_slip", box = {min = [0, 0, 0], max = [5, 5, 6], open = ["+z"]}}]
stage = [{name = "go", duration = 1}]
)",
                                "room.toml");
  EXPECT_EQ(doubled_walls(scene).size(), 1U);
  scene.walls[1].facets = box_facets({{0, 0, 0}, {5, 5, 6}}, {"+z", "-z"}, 3);
  EXPECT_TRUE(doubled_walls(scene).empty());
}

std::string refusal(const Scene& scene) {
  try {
    check_wall_clearance(scene, generate_soil(scene));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

TEST(WallClearanceTest, ARoughWallWithoutRoomForDummiesIsRefused) {
  using enum WallKind;
  const std::string message = refusal(slot(0.1, no_slip, no_slip));
  EXPECT_NE(message.find("'left': behind its face before the soil at (9.75, "), std::string::npos)
      << message;
  EXPECT_NE(message.find("a slot of 1.5 m or more"), std::string::npos) << message;
  EXPECT_EQ(refusal(slot(0.3, no_slip, no_slip)), "");
  // A pile that tapers to nothing has room elsewhere.
  Scene pile = slot(0.1, no_slip, no_slip);
  pile.bodies = {{.shape = Polygon{{{0, 0}, {9, 0}, {9.9, 4.5}, {0, 4.5}}}},
                 {.shape = Polygon{{{11, 0}, {20, 0}, {20, 4.5}, {10.1, 4.5}}}}};
  pile.walls = {line_wall("pile", no_slip, {{9, 0}, {10, 5}, {11, 0}})};
  EXPECT_EQ(refusal(pile), "");
}

/// The top of a height field by an expression is looked up: what is said of a box as high is said
/// of it.
TEST(HeightFieldTest, AnExpressionIsAsHighAsItsColumns) {
  const auto warnings_of = [](const std::string& shape) {
    return warnings(read_scene_text(R"(
dimension = 3
spacing = 0.5
preset = "paper"
material = [{name = "s", density = 2000, youngs_modulus = "300 kPa", poisson_ratio = 0.3, cohesion = 5, friction_angle = "30 deg"}]
body = [{material = "s", )" + shape + R"(}]
wall = [{name = "base", kind = "no_slip", rectangle = {origin = [0, 0, 0], u = [10, 0, 0], v = [0, 10, 0]}}]
stage = [{name = "go", duration = 20}]
)",
                                    "hill.toml"));
  };
  const std::vector<std::string> of_box = warnings_of("box = {min = [0, 0, 0], max = [10, 10, 8]}");
  EXPECT_GE(of_box.size(), 3U);  // it settles, its cohesion is in Pa, its lattice does not stand
  EXPECT_EQ(warnings_of("height_field = {plan = [[0, 0], [10, 10]], base = 0, expression = \"8\"}"),
            of_box);
}

}  // namespace
}  // namespace scarp::test
