// SPDX-License-Identifier: BSD-3-Clause
/// Scenes made in code: the short forms, and what may be left out or named wrong.
#include "engine/scene/shorthand.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "engine/errors.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

TEST(ShorthandTest, DegreesAreRadians) {
  EXPECT_DOUBLE_EQ(degrees(180.0), std::numbers::pi);
  EXPECT_DOUBLE_EQ(degrees(-20.0), -std::numbers::pi / 9.0);
}

TEST(ShorthandTest, SoilLiesOnTheLeftOfALine) {
  const Wall wall = no_slip("base", line({{0, 0}, {3, 0}, {3, 4}}));
  EXPECT_EQ(wall.name, "base");
  EXPECT_EQ(wall.kind, WallKind::no_slip);
  ASSERT_EQ(wall.facets.size(), 2U);
  EXPECT_EQ(wall.facets[0].normal, (Vec3{0, 1, 0}));
  EXPECT_EQ(wall.facets[1].normal, (Vec3{-1, 0, 0}));
  EXPECT_EQ(wall.facets[1].length_u, 4.0);
  EXPECT_EQ(free_slip("side", line({{0, 0}, {0, 1}})).kind, WallKind::free_slip);
  EXPECT_THROW(static_cast<void>(line({{1, 1}})), GeometryError);
}

std::string refusal_of(const Scene& scene) {
  try {
    validate(scene);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "accepted";
}

Scene two_layers() {
  return {.spacing = 0.1,
          .materials = {clay(), elastic()},
          .bodies = {{.shape = box({0, 0}, {1, 1}), .material = "clay"},
                     {.shape = polygon({{0, 1}, {1, 1}, {1, 2}}), .material = "elastic"}},
          .walls = {no_slip("base", line({{0, 0}, {1, 0}}))},
          .stages = {{.name = "fall", .duration = 1.0}}};
}

TEST(ShorthandTest, ABodyIsMadeOfTheMaterialItNames) {
  const Scene scene = two_layers();
  EXPECT_NO_THROW(validate(scene));
  EXPECT_EQ(material_of(scene, scene.bodies[0]), 0U);
  EXPECT_EQ(material_of(scene, scene.bodies[1]), 1U);
}

TEST(ShorthandTest, ABodyOfNoMaterialIsRefusedByName) {
  Scene scene = two_layers();
  scene.bodies[1].material = "elastik";
  EXPECT_EQ(refusal_of(scene),
            "key 'body[1].material' = \"elastik\": no material has this name. Did you mean "
            "'elastic'?");
  scene.bodies[1].material.clear();
  EXPECT_EQ(refusal_of(scene),
            "key 'body[1].material' = \"\": the scene has 2 materials. Try the name of one: clay, "
            "elastic.");
  scene.materials.pop_back();
  scene.bodies[0].material.clear();
  EXPECT_NO_THROW(validate(scene));  // both are of the only one
}

TEST(ShorthandTest, AStageThatEndsByTimeNeedsOne) {
  Scene scene = two_layers();
  for (const std::optional<double> none : {std::optional<double>(), std::optional(0.0)}) {
    scene.stages[0].duration = none;
    EXPECT_NE(refusal_of(scene).find("the stage would take no time"), std::string::npos);
  }
  scene.stages[0].duration.reset();
  scene.stages[0].until = StageEnd::rest;
  EXPECT_NO_THROW(validate(scene));
}

}  // namespace
}  // namespace scarp::test
