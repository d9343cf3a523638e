// SPDX-License-Identifier: BSD-3-Clause
/// Columns of dummies: which there are. What they do is in rough_walls_test.cpp.
#include "engine/boundary/wall_columns.hpp"

#include <gtest/gtest.h>

#include "tests/engine/boundary/line_walls.hpp"

namespace scarp::test {
namespace {

Scene with_columns(Scene scene) {
  scene.numerics.force_correction = true;
  return scene;
}

std::size_t members(const WallDummies& dummies, std::size_t column) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < dummies.column.size(); ++k)
    count += dummies.column[k] == column && k != dummies.columns[column].inner ? 1 : 0;
  return count;
}

TEST(WallColumnsTest, EveryLineOfDummiesAboveAFaceIsOne) {
  const Scene scene = with_columns(line_scene({{0, 0}, {6, 8}}));
  const WallDummies dummies = generate_dummies(scene);
  ASSERT_EQ(dummies.columns.size(), 20U);
  ASSERT_EQ(dummies.position.size(), 60U + 20U);
  const Vec3 normal{-0.8, 0.6, 0.0};
  for (std::size_t c = 0; c < dummies.columns.size(); ++c) {
    EXPECT_EQ(members(dummies, c), 3U);
    const auto [first, inner] = dummies.columns[c];
    for (std::size_t a = 0; a < 3; ++a) {
      // 0.25 m behind the face to 1 m before it.
      EXPECT_NEAR(dummies.position[inner][a] - dummies.position[first][a], 1.25 * normal[a], 1e-12);
    }
    EXPECT_DOUBLE_EQ(dummies.distance[inner], -1.0);
  }
  EXPECT_TRUE(generate_dummies(line_scene({{0, 0}, {6, 8}})).columns.empty());
}

TEST(WallColumnsTest, EndWhereAnotherFaceStandsBeforeTheInnerPoint) {
  // A roof 0.75 m over the right half of the base, and one 1.25 m over the left half.
  Scene scene = with_columns(line_scene({{0, 0}, {10, 0}}));
  scene.walls.push_back(line_wall("low", WallKind::free_slip, {{10, 0.75}, {5, 0.75}}));
  scene.walls.push_back(line_wall("high", WallKind::free_slip, {{5, 1.25}, {0, 1.25}}));
  const WallDummies dummies = generate_dummies(scene);
  EXPECT_EQ(dummies.columns.size(), 10U);
  for (const WallColumn& column : dummies.columns)
    EXPECT_LT(dummies.position[column.first][0], 5.0);
}

TEST(WallColumnsTest, GoOnBehindASmoothFace) {
  // There the base goes on by its thickness, three columns, and images of the soil stand over it.
  Scene scene = with_columns(line_scene({{0, 0}, {10, 0}}));
  scene.walls.push_back(line_wall("side", WallKind::free_slip, {{10, 0}, {10, 5}}));
  const WallDummies dummies = generate_dummies(scene);
  EXPECT_EQ(dummies.columns.size(), 20U + 3U);
  for (const std::size_t column : dummies.column) EXPECT_NE(column, no_column);
}

}  // namespace
}  // namespace scarp::test
