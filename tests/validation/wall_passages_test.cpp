// SPDX-License-Identifier: BSD-3-Clause
/// What the stability map counts as a grain that passed a wall.
#include <gtest/gtest.h>

#include <vector>

#include "validation/stability/cell_run.hpp"
#include "validation/stability/scenes.hpp"
#include "validation/stability/wall_passages.hpp"

namespace scarp::validation {
namespace {

/// A bed of 10 x 2 m with sides of 8 m, dx = 0.5 m, and a plate of 1 m along its middle.
Scene walled() {
  Scene scene = bed_scene("modern", 10, 2, 0.5);
  scene.walls.push_back(
      wall_2d("plate", WallKind::no_slip, {line_2d(5, 0, 5, 8), line_2d(6, 8, 6, 0)}));
  return scene;
}

/// How many of one have passed after this way, in stage 0 and then in those given.
double passed_on(const Scene& scene, const std::vector<Vec3>& way,
                 std::vector<std::size_t> stages = {}) {
  stages.resize(way.size(), 0);
  WallPassages passages(scene, way.front());
  for (std::size_t k = 1; k < way.size(); ++k) passages.follow(way[k], stages[k]);
  return passages.passed();
}

TEST(WallPassages, SeesAGrainThatGoesThroughAWall) {
  const Scene scene = walled();
  EXPECT_EQ(passed_on(scene, {{0.1, 3}, {-0.1, 3}, {-0.3, 3}}), 1.0);  // smooth side
  EXPECT_EQ(passed_on(scene, {{3, 0.1}, {3, -5.0}}), 1.0);             // at once and far
  EXPECT_EQ(passed_on(scene, {{4.9, 1}, {5.2, 1}, {5.4, 1}}), 1.0);    // into the plate
  EXPECT_EQ(passed_on(scene, {{4.9, 1}, {6.4, 1}}), 1.0);              // out of its other side
  EXPECT_EQ(passed_on(scene, {{0.1, 7.9}, {-0.2, 7.9}, {-0.2, 9}, {-0.4, 9}}), 1.0);  // goes on up
  // What passed once has passed, wherever it goes.
  EXPECT_EQ(passed_on(scene, {{0.1, 3}, {-0.3, 3}, {0.1, 3}}), 1.0);
}

TEST(WallPassages, DoesNotCountWhatGoesRoundOrIsHeld) {
  const Scene scene = walled();
  EXPECT_EQ(passed_on(scene, {{0.5, 9}, {-0.5, 8.2}, {-0.5, 5}, {-0.5, 1}}), 0.0);  // over the top
  EXPECT_EQ(passed_on(scene, {{4.5, 9}, {6.5, 8.5}, {6.5, 1}}), 0.0);  // over the plate
  EXPECT_EQ(passed_on(scene, {{0.1, 3}, {-0.2, 3}, {0.1, 3}}), 0.0);   // dx/2 is held
  EXPECT_EQ(passed_on(scene, {{-0.5, 9}, {-0.5, 5}, {0.5, 5}}), 0.0);  // comes back from behind
  // Held off in the face, it comes out again and flies over.
  EXPECT_EQ(passed_on(scene, {{0.1, 5}, {-0.1, 5}, {0.1, 6}, {0.1, 9}, {-0.4, 8.5}, {-0.4, 5}}),
            0.0);
}

TEST(WallPassages, AWallThatIsGoneIsNoWall) {
  Scene scene = walled();
  scene.walls[1].removed_at = "go";
  EXPECT_EQ(passed_on(scene, {{0.5, 3}, {-0.5, 3}}, {0, 1}), 0.0);
  EXPECT_EQ(passed_on(scene, {{0.5, 3}, {-0.5, 3}}, {0, 0}), 1.0);
}

/// The false alarm of earlier maps: a grain thrown over a wall of 2 m falls beside it, within 3 dx
/// of its back.
TEST(WallPassages, ACellDoesNotFailWhereAGrainFallsBehindAWall) {
  Cell cell;
  cell.scene = bed_scene("modern", 4, 1, 0.5);
  cell.scene.walls[1] =
      wall_2d("sides", WallKind::free_slip, {line_2d(0, 2, 0, 0), line_2d(4, 0, 4, 2)});
  cell.scene.bodies.push_back(box_of("soil", 3.5, 4.5, 4, 5));
  cell.scene.bodies.back().velocity = {0.8, 0, 0};
  cell.scene.stages = {lasting("go", 0.85)};
  Simulation simulation(cell.scene, {1, {}});
  while (!simulation.finished()) simulation.step();
  const std::vector<double> x = simulation.field("position");
  const std::size_t last = x.size() - 3;
  ASSERT_GT(x[last], 4.25);
  ASSERT_LT(x[last], 5.5);
  ASSERT_LT(x[last + 1], 2.0);
  ASSERT_GT(x[last + 1], 0.0);
  const CellRecord record = run_cell(cell, {1, {}});
  EXPECT_EQ(record.verdict, Verdict::holds) << record.reason;
  EXPECT_EQ(record.lost, 0.0);
}

}  // namespace
}  // namespace scarp::validation
