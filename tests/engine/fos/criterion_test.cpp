// SPDX-License-Identifier: BSD-3-Clause
/// What a scene says before any trial: height, criterion, whether its strength can be cut.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/fos/dilation_note.hpp"
#include "engine/fos/slope_height.hpp"
#include "tests/support/coarse_slope.hpp"

namespace scarp {
namespace {

using test::coarse_slope;
using test::message_of;
using test::settled_slope;

TEST(SlopeHeight, IsThatOfTheGround) {
  Scene scene = coarse_slope();
  EXPECT_NEAR(slope_height(scene), 10.0, 1e-6);
  // A bench on top is ground; a body under it is not.
  scene.bodies.push_back({.shape = Box{{0, 15, 0}, {4, 17, 0}}});
  scene.bodies.push_back({.shape = Box{{0, 0, 0}, {20, 1, 0}}});
  EXPECT_NEAR(slope_height(scene), 12.0, 1e-6);
}

TEST(SlopeHeight, OfAHeightFieldIn3D) {
  Scene scene;
  scene.dimension = 3;
  scene.gravity = {0, 0, -9.81};
  scene.spacing = 1.0;
  HeightField field;
  field.plan_maximum = {40.0, 12.0};
  field.profile = {{{12.0, 16.0}, {24.0, 4.0}}};
  scene.bodies = {{.shape = field}};
  EXPECT_NEAR(slope_height(scene), 12.0, 1e-6);
}

TEST(SlopeHeight, OfObliqueGravityIsAlongItAndNotAlongTheWalls) {
  Scene scene = coarse_slope();
  // The ground from its upper left end (0, 15) to the lower right one (45, 5), seen along gravity.
  // Straight up from the left side, too, is the sky; but the wall is there.
  for (const double tilt : {0.1, 0.3}) {
    scene.gravity = {9.81 * std::sin(tilt), -9.81 * std::cos(tilt), 0.0};
    const double along = 10.0 * std::cos(tilt) + 45.0 * std::sin(tilt);
    EXPECT_NEAR(slope_height(scene), along, scene.spacing) << tilt;
  }
  // Almost straight down it is that of the straight rule.
  scene.gravity = {1e-9, -9.81, 0.0};
  EXPECT_NEAR(slope_height(scene), 10.0, scene.spacing);
}

TEST(SlopeHeight, OfAPlaneTiltedIn3D) {
  Scene scene;
  scene.dimension = 3;
  scene.spacing = 0.5;
  scene.gravity = {9.81 * 0.6, 0.0, -9.81 * 0.8};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {10, 3, 2}}}};
  scene.materials = {test::elastic()};
  scene.walls = {test::wall_of("end", WallKind::no_slip,
                               {{{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 3, 2, {1, 0, 0}}})};
  EXPECT_NEAR(slope_height(scene), 10.0 * 0.6, scene.spacing);
}

TEST(CriterionTest, FollowsHeightAndGravity) {
  const Scene scene = coarse_slope();
  const double free_fall = std::sqrt(2.0 * 10.0 / 9.81);
  const Criterion own = choose_criterion(scene, {});
  EXPECT_NEAR(own.limit, 0.1, 1e-8);
  EXPECT_NEAR(own.window, 5.0 * free_fall, 1e-6);
  EXPECT_NEAR(own.ramp, 1.4 * free_fall, 1e-6);
  EXPECT_EQ(own.probe, "crest");
  CriterionOptions options;
  options.height = 20.0;
  options.window = 3.0;
  options.ramp = 0.0;
  const Criterion given = choose_criterion(scene, options);
  EXPECT_EQ(given.limit, 0.2);
  EXPECT_EQ(given.window, 3.0);
  EXPECT_EQ(given.ramp, 0.0);
}

TEST(CriterionTest, SoilThatSoftensIsJudgedOverTheWholeWindow) {
  Scene scene = coarse_slope();
  EXPECT_TRUE(choose_criterion(scene, {}).early_stop);
  SoilModel& soil = scene.materials.front().model;
  soil.set("softening_slip", 0.1);
  EXPECT_TRUE(choose_criterion(scene, {}).early_stop) << "no residual strength below the peak";
  soil.set("residual_cohesion", 0.5 * soil.parameter("cohesion"));
  EXPECT_FALSE(choose_criterion(scene, {}).early_stop);
  // It may come to rest for a while: no trial of it ends for that.
  StrengthReduction slope = settled_slope(scene);
  ASSERT_TRUE(slope.measure_elastic({}));
  EXPECT_EQ(slope.respond(1.05, {})->end, TrialEnd::window_over);
}

TEST(CriterionTest, SaysWhatASceneLacks) {
  Scene level = coarse_slope();
  level.bodies = {{.shape = Box{{0, 0, 0}, {45, 5, 0}}}};
  EXPECT_NE(message_of([&] { choose_criterion(level, {}); }).find("level"), std::string::npos);
  CriterionOptions options;
  options.probe = "crset";
  EXPECT_NE(message_of([&] { choose_criterion(coarse_slope(), options); }).find("'crest'"),
            std::string::npos);
}

TEST(Reducible, NeedsASettledStateAndALastStageThatOnlyCuts) {
  EXPECT_NO_THROW(check_reducible(coarse_slope()));
  Scene one = coarse_slope();
  one.stages.erase(one.stages.begin());
  EXPECT_NE(message_of([&] { check_reducible(one); }).find("settle"), std::string::npos);
  Scene unsettled = coarse_slope();
  unsettled.stages.front().until = StageEnd::duration;
  EXPECT_NE(message_of([&] { check_reducible(unsettled); }).find("until = \"rest\""),
            std::string::npos);
  Scene opened = coarse_slope();
  opened.walls.back().removed_at = "fail";
  EXPECT_NE(message_of([&] { check_reducible(opened); }).find("'right'"), std::string::npos);
  Scene elastic = coarse_slope();
  elastic.materials = {test::elastic()};
  EXPECT_NE(message_of([&] { check_reducible(elastic); }).find("yield"), std::string::npos);
}

TEST(DilationNoteTest, NamesMaterialsWithFrictionAloneAndBoundsTheFactor) {
  Scene scene = coarse_slope();
  EXPECT_FALSE(dilation_note(scene));
  EXPECT_TRUE(looks_reducible(scene));
  scene.materials.front().model.set("dilation_angle", 0.0);
  const std::optional<std::string> note = dilation_note(scene, 1.332);
  ASSERT_TRUE(note);
  EXPECT_NE(note->find("'clay'"), std::string::npos);
  // 1.332 sqrt(1 + 4/3 (tan 20 deg/1.332)^2) = 1.397
  EXPECT_NE(note->find("up to 1.397"), std::string::npos) << *note;
  EXPECT_EQ(dilation_note(scene)->find("up to"), std::string::npos);
  scene.materials.front().model.set("friction_angle", 0.0);
  EXPECT_FALSE(dilation_note(scene));
  scene.stages.pop_back();
  EXPECT_FALSE(looks_reducible(scene));
}

}  // namespace
}  // namespace scarp
