// SPDX-License-Identifier: BSD-3-Clause
/// Soil with nothing below it is told before a run, with its place and width; supported soil is
/// not.
#include <gtest/gtest.h>

#include "engine/check/wall_support.hpp"
#include "engine/particles/generate.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

std::vector<std::string> told(const Scene& scene) {
  return soil_over_nothing(scene, generate_soil(scene).position);
}

void expect_told(const Scene& scene, std::initializer_list<const char*> words) {
  const std::vector<std::string> found = told(scene);
  ASSERT_EQ(found.size(), 1U) << (found.size() > 1 ? found[1] : "nothing found");
  for (const char* word : words) EXPECT_NE(found[0].find(word), std::string::npos) << found[0];
}

/// A bed 2 m x 0.5 m at 0.05 m on a base in two parts, `gap` wide apart from x = 1 on.
Scene bed(double gap) {
  Scene scene;
  scene.spacing = 0.05;
  scene.materials = {elastic()};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {2, 0.5, 0}}}};
  scene.walls = {wall_of("left", WallKind::no_slip, {facet_2d(0, 0, 1, 0)}),
                 wall_of("right", WallKind::no_slip, {facet_2d(1 + gap, 0, 2, 0)})};
  scene.stages = {stage_for("first", 1.0), stage_for("second", 1.0)};
  return scene;
}

TEST(WallSupportTest, HolesOfAnyWidthAreNamedWithPlaceAndWidth) {
  EXPECT_TRUE(told(bed(0.0)).empty());
  // Columns stand at 1.025, 1.075, ...; each has ten particles.
  expect_told(bed(0.05), {"below 10 of 400 particles (2.5 %), 0.05 m wide", "(1.025, "});
  expect_told(bed(0.15), {"below 30 of 400", "0.15 m wide", "from (1.025, ", "to (1.125, "});
  expect_told(bed(0.5), {"below 100 of 400", "0.5 m wide", "from (1.025, ", "to (1.475, "});
}

TEST(WallSupportTest, AFloorAnywhereBelowIsSupport) {
  Scene scene = bed(0.5);
  scene.walls.push_back(wall_of("cellar", WallKind::free_slip, {facet_2d(0.5, -40, 2, -41)}));
  EXPECT_TRUE(told(scene).empty());
  scene.walls.back().facets = {facet_2d(2, -40, 0.5, -40)};  // faces down
  expect_told(scene, {"below 100 of 400"});
}

TEST(WallSupportTest, SoilBelowItsBaseAndBesideItIsNamed) {
  Scene scene = bed(0.0);
  scene.bodies = {{.shape = Box{{0, -1, 0}, {2, -0.5, 0}}}};
  expect_told(scene, {"no wall lies below any of the soil", "on the left"});
  scene = bed(0.0);
  scene.bodies = {{.shape = Box{{0, 0, 0}, {2.2, 0.5, 0}}}};
  expect_told(scene, {"below 40 of 440", "0.2 m wide"});
  scene.gravity = {};
  EXPECT_TRUE(told(scene).empty());
}

TEST(WallSupportTest, WallsThatGoAreNamedWithTheirStage) {
  Scene scene = bed(0.0);
  scene.walls[1].removed_at = "second";
  expect_told(scene,
              {"once wall 'right' is removed (stage 'second'), no wall lies below 200 of 400"});
  scene.walls[0].removed_at = "second";
  expect_told(scene, {"once wall 'left', 'right' is removed (stage 'second'),", "any of the soil"});
}

TEST(WallSupportTest, WallsThatMoveAwayAreNamed) {
  Scene scene = bed(0.0);
  scene.walls[1].velocity = {0.3, 0, 0};
  scene.walls[1].moves_from = "second";
  expect_told(scene, {"once wall 'right' has moved (end of stage 'second')", "below 60 of 400"});
  scene.walls[1].velocity = {0, -0.3, 0};  // a trapdoor is still below
  EXPECT_TRUE(told(scene).empty());
  for (Wall& wall : scene.walls) wall.velocity = {0.3, 0, 0};  // both from the second stage on
  scene.walls[0].moves_from = "second";
  EXPECT_TRUE(told(scene).empty());  // carry their soil along
}

TEST(WallSupportTest, GravityMayPointAnywhere) {
  // Turned by 90 degrees: the base is a wall at x = 0 that faces +x.
  Scene scene = bed(0.15);
  scene.gravity = {-9.81, 0, 0};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {0.5, 2, 0}}}};
  scene.walls[0].facets = {facet_2d(0, 1, 0, 0)};
  scene.walls[1].facets = {facet_2d(0, 2, 0, 1.15)};
  expect_told(scene, {"below 30 of 400", "0.15 m wide", "1.025)", "1.125)"});
  // Tilted by 15 degrees: soil over the downhill end hangs over the edge, unless a wall stands
  // there.
  scene = bed(0.0);
  scene.gravity = {2.54, -9.48, 0};
  EXPECT_EQ(told(scene).size(), 1U);
  scene.walls.push_back(wall_of("toe", WallKind::free_slip, {facet_2d(2, 0, 2, 1)}));
  EXPECT_TRUE(told(scene).empty());
}

TEST(WallSupportTest, HolesInAFloorIn3D) {
  Scene scene = small_collapse("modern", 0.02, 0.1);
  EXPECT_TRUE(told(scene).empty());  // the gate carries nothing
  Facet& floor = scene.walls[0].facets[0];
  floor.length_u = 0.08;
  Facet other = floor;
  other.origin[0] = 0.14;
  other.length_u = 0.8;
  scene.walls[0].facets.push_back(other);
  // 3 of 12 columns along x, all 8 along y and 8 along z.
  expect_told(scene, {"below 192 of 768 particles (25 %), 0.06 m by 0.16 m wide"});
}

TEST(WallSupportTest, CoversWhatAFullScaleSlopeStandsOn) {
  EXPECT_TRUE(told(small_slope("modern", 1.0, 1.0, 1.0)).empty());
}

}  // namespace
}  // namespace scarp::test
