// SPDX-License-Identifier: BSD-3-Clause
/// `slope = {...}` of [[body]]: outlines, and what is wrong with a slope.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/errors.hpp"
#include "engine/scene/scene_reader.hpp"
#include "tests/support/scene_message.hpp"

namespace scarp {
namespace {

using Points = std::vector<std::array<double, 2>>;

std::string scene_of(const std::string& slope, bool solid) {
  const std::string floor = solid
                                ? "rectangle = {origin = [0, 0, 0], u = [50, 0, 0], v = [0, 10, 0]}"
                                : "line = [[0, 0], [50, 0]]";
  return "dimension = " + std::string(solid ? "3" : "2") + R"(
spacing = 1
[[material]]
name = "clay"
density = 2000
youngs_modulus = "10 MPa"
poisson_ratio = 0.3
cohesion = "10 kPa"
friction_angle = "20 deg"
[[body]]
material = "clay"
slope = )" +
         slope + R"(
[[wall]]
name = "base"
kind = "no_slip"
)" + floor +
         R"(
[[stage]]
name = "fall"
duration = 1
)";
}

Polygon polygon_of(const std::string& slope, bool solid = false) {
  return std::get<Polygon>(read_scene_text(scene_of(slope, solid), "slope.toml").bodies[0].shape);
}

/// What the reader says of a slope.
std::string complaint(const std::string& slope) {
  try {
    read_scene_text(scene_of(slope, false), "slope.toml");
  } catch (const SceneError& error) {
    EXPECT_EQ(fault_of_message(error.what(), "slope.toml"), "") << error.what();
    return error.what();
  }
  return "";
}

TEST(SlopeShapeTest, IsTheOutlineThatItsWordsSay) {
  EXPECT_EQ(
      polygon_of("{toe = [32, 5], height = 10, ratio = 2, crest = 12, ground = 13, depth = 5}")
          .points,
      (Points{{0, 0}, {45, 0}, {45, 5}, {32, 5}, {12, 15}, {0, 15}}));
}

TEST(SlopeShapeTest, LengthsThatAreNotSaidAreHeights) {
  EXPECT_EQ(polygon_of("{toe = [50, 10], height = \"1000 cm\", ratio = 1}").points,
            (Points{{20, 0}, {70, 0}, {70, 10}, {50, 10}, {40, 20}, {20, 20}}));
}

TEST(SlopeShapeTest, HasBermsAndCanFallToTheOtherSide) {
  EXPECT_EQ(
      polygon_of("{toe = [0, 4], height = 8, ratio = 1, crest = 4, ground = 3, depth = 4, "
                 "berms = [[2, 1], [5, 2]], faces = \"-x\"}")
          .points,
      (Points{
          {15, 0}, {-3, 0}, {-3, 4}, {0, 4}, {2, 6}, {3, 6}, {6, 9}, {8, 9}, {11, 12}, {15, 12}}));
}

TEST(SlopeShapeTest, AVerticalCutWithoutGroundIsABox) {
  const Points box{{-3, 0}, {0, 0}, {0, 4}, {-3, 4}};
  EXPECT_EQ(
      polygon_of("{toe = [0, 0], height = 4, ratio = 0, crest = 3, ground = 0, depth = 0}").points,
      box);
  const Points upright =
      polygon_of("{toe = [0, 0], height = 4, angle = \"90 deg\", crest = 3, ground = 0, depth = 0}")
          .points;
  ASSERT_EQ(upright.size(), box.size());
  for (std::size_t k = 0; k < box.size();
       ++k)  // the cosine of a rounded right angle, times the height
    EXPECT_NEAR(upright[k][0], box[k][0], 4 * 2.3e-16);
}

TEST(SlopeShapeTest, AnAngleIsARatio) {
  const Points points = polygon_of("{toe = [0, 0], height = 3, angle = \"30 deg\"}").points;
  EXPECT_NEAR(points[4][0], -3.0 * std::sqrt(3.0),
              3 * 4 * 2.3e-16);  // some roundings of a length of 5
}

TEST(SlopeShapeTest, IsExtrudedInThreeDimensions) {
  const Polygon polygon =
      polygon_of("{toe = [32, 5], height = 10, ratio = 2}\nextrude = [0, 10]", true);
  EXPECT_EQ(polygon.extrude, (std::array<double, 2>{0, 10}));
  EXPECT_EQ(polygon.points[3], (std::array<double, 2>{32, 5}));
}

TEST(SlopeShapeTest, WhatIsWrongIsNamed) {
  const auto names = [](const std::string& slope, const std::string& key) {
    EXPECT_NE(complaint(slope).find("slope" + key), std::string::npos) << complaint(slope);
  };
  names("{toe = [0, 5], height = 0, ratio = 2}", ".height");
  names("{toe = [0, 5], height = 5, ratio = -1}", ".ratio");
  names("{toe = [0, 5], height = 5, angle = \"120 deg\"}", ".angle");
  names("{toe = [0, 5], height = 5, ratio = 2, crest = 0}", ".crest");
  names("{toe = [0, 5], height = 5, ratio = 2, ground = -1}", ".ground");
  names("{toe = [0, 5], height = 5, ratio = 2, berms = [[6, 1]]}", ".berms");
  names("{toe = [0, 5], height = 5, ratio = 2, berms = [[2, 1], [2, 1]]}", ".berms");
  names("{toe = [0, 5], height = 5, ratio = 2, depth = 0}", "'");
  names("{toe = [0, 5], height = 5}", "");
  names("{toe = [0, 5], height = 5, ratio = 2, angle = \"30 deg\"}", "");
  names("{toe = [0, 5], height = 5, ratio = 2, bench = 3}", ".bench");
}

}  // namespace
}  // namespace scarp
