// SPDX-License-Identifier: BSD-3-Clause
/// Layout of the dummy particles: layers, corners, ownership, errors; and soil inside walls.
#include "engine/boundary/dummies.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/errors.hpp"
#include "engine/scene/facets.hpp"
#include "tests/engine/boundary/line_walls.hpp"

namespace scarp::test {
namespace {

double nearest_pair(const WallDummies& dummies) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < dummies.position.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Vec3 &a = dummies.position[i], &b = dummies.position[j];
      nearest = std::min(nearest, std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]));
    }
  }
  return nearest;
}

/// Every dummy lies at its distance, above 0 and within the thickness, behind a plane of its wall
/// that has its normal.
void expect_consistent(const Scene& scene, const WallDummies& dummies) {
  const double thickness = wall_layers(scene) * scene.spacing;
  for (std::size_t k = 0; k < dummies.position.size(); ++k) {
    EXPECT_GT(dummies.distance[k], 0.0);
    EXPECT_LT(dummies.distance[k], thickness);
    bool found = false;
    for (const Facet& facet : scene.walls[dummies.wall[k]].facets) {
      double depth = 0.0;
      for (std::size_t a = 0; a < 3; ++a) {
        depth += (facet.origin[a] - dummies.position[k][a]) * facet.normal[a];
      }
      found = found ||
              (facet.normal == dummies.normal[k] && std::abs(depth - dummies.distance[k]) < 1e-9);
    }
    EXPECT_TRUE(found) << "dummy " << k;
  }
}

TEST(WallLayersTest, CoverTheSupportOfAParticleOnTheFace) {
  Scene scene = empty_scene(2);
  // The first layer left out, at (layers + 1/2) dx, is 2h away or more: 2.4, 2.5, 3, 3.2, 4 dx.
  const std::map<double, int> wanted = {{1.2, 2}, {1.25, 2}, {1.5, 3}, {1.6, 3}, {2.0, 4}};
  for (const auto& [ratio, layers] : wanted) {
    scene.numerics.smoothing_ratio = ratio;
    EXPECT_EQ(wall_layers(scene), layers) << ratio;
  }
}

TEST(GenerateDummiesTest, FreeFacetHoldsItsColumnsInEveryLayer) {
  const Scene scene = line_scene({{0, 0}, {10, 0}});
  const WallDummies dummies = generate_dummies(scene);
  ASSERT_EQ(dummies.position.size(), 60U);
  std::map<double, int> per_layer;
  for (std::size_t k = 0; k < 60; ++k) {
    ++per_layer[dummies.distance[k]];
    EXPECT_EQ(dummies.position[k][1], -dummies.distance[k]);
    EXPECT_TRUE(dummies.position[k][0] > 0.0 && dummies.position[k][0] < 10.0);
  }
  EXPECT_EQ(per_layer, (std::map<double, int>{{0.25, 20}, {0.75, 20}, {1.25, 20}}));
  expect_consistent(scene, dummies);
}

TEST(GenerateDummiesTest, RestOfALengthIsSharedByBothEnds) {
  const WallDummies dummies = generate_dummies(line_scene({{0, 0}, {10.2, 0}}));
  ASSERT_EQ(dummies.position.size(), 63U);
  double first = 1e9, last = -1e9;
  for (const Vec3& p : dummies.position) {
    first = std::min(first, p[0]);
    last = std::max(last, p[0]);
  }
  EXPECT_NEAR(first, 10.2 - last, 1e-12);
  EXPECT_NEAR(last - first, 10.0, 1e-12);
}

TEST(GenerateDummiesTest, ConcaveCornersAreFilledOncePerLatticeSite) {
  // A trough: left wall, base, right wall.
  const Scene scene = line_scene({{0, 5}, {0, 0}, {10, 0}, {10, 5}});
  const WallDummies dummies = generate_dummies(scene);
  const auto held = cells(dummies, 0.5);
  for (int i = -4; i < 25; ++i) {
    for (int j = -4; j < 15; ++j) {
      const bool beside = (i >= -3 && i < 0) || (i >= 20 && i < 23);
      const bool wall = (beside && j >= -3 && j < 10) || (i >= 0 && i < 20 && j >= -3 && j < 0);
      EXPECT_EQ(held.count({i, j, 0}) != 0U ? held.at({i, j, 0}) : 0, wall ? 1 : 0)
          << i << " " << j;
    }
  }
  EXPECT_EQ(dummies.position.size(), 2U * 3U * 13U + 20U * 3U);
  expect_consistent(scene, dummies);
}

TEST(GenerateDummiesTest, TroughOffTheLatticeIsSymmetricWithoutCloseNeighbours) {
  const double spacing = 0.3;  // divides neither 10 nor 5
  const Scene scene = line_scene({{0, 5}, {0, 0}, {10, 0}, {10, 5}}, spacing);
  const WallDummies dummies = generate_dummies(scene);
  EXPECT_GE(nearest_pair(dummies), 0.5 * spacing * (1.0 - 1e-5));
  std::size_t left = 0, right = 0;
  for (const Vec3& p : dummies.position) {
    left += p[0] < 0.0;
    right += p[0] > 10.0;
    EXPECT_FALSE(p[0] > 0 && p[0] < 10 && p[1] > 0);
  }
  // Side walls of 17 columns, and corners of 3 x 3 sites.
  EXPECT_EQ(left, 3U * 17U + 9U);
  EXPECT_EQ(right, left);
  expect_consistent(scene, dummies);
}

TEST(GenerateDummiesTest, ConvexCornerLeavesNothingOnTheSoilSide) {
  // A step down at x = 5: soil above y = 3 on the left, above y = 0 on the right.
  const Scene scene = line_scene({{0, 3}, {5, 3}, {5, 0}, {10, 0}});
  const WallDummies dummies = generate_dummies(scene);
  const auto held = cells(dummies, 0.5);
  for (int i = 0; i < 20; ++i) {
    for (int j = -3; j < 10; ++j) {
      const bool soil = i < 10 ? j >= 6 : j >= 0;
      const bool near = i < 10 ? (j >= 3 || i >= 7) : j >= -3;
      const auto count = held.count({i, j, 0}) != 0U ? held.at({i, j, 0}) : 0;
      EXPECT_EQ(count, !soil && near ? 1 : 0) << i << " " << j;
    }
  }
  expect_consistent(scene, dummies);
}

TEST(GenerateDummiesTest, ObtuseAndAcuteConcaveCornersAreClosed) {
  // Wherever soil may be near the corner, the wall side of its support holds dummies without a gap.
  for (const Points2& points :
       {Points2{{0, 0}, {10, 0}, {15, 5}}, Points2{{0, 0}, {10, 0}, {5, 5}}}) {
    const Scene scene = line_scene(points);
    const WallDummies dummies = generate_dummies(scene);
    expect_consistent(scene, dummies);
    EXPECT_GE(nearest_pair(dummies), 0.25 * (1.0 - 1e-5));
    const auto& end = points[2];
    const double length = std::hypot(end[0] - 10.0, end[1]);
    const double nx = -end[1] / length, ny = (end[0] - 10.0) / length;
    for (double angle = -3.1; angle < 3.1; angle += 0.05) {
      for (double radius = 0.1; radius < 1.0; radius += 0.1) {
        const double x = radius * std::cos(angle), y = radius * std::sin(angle);
        if (y > 0.0 && nx * x + ny * y > 0.0) continue;  // soil
        double nearest = 1e9;
        for (const Vec3& p : dummies.position) {
          nearest = std::min(nearest, std::hypot(p[0] - 10.0 - x, p[1] - y));
        }
        // Half the diagonal of a cell is 0.35; a seam may be up to half a spacing wider.
        EXPECT_LT(nearest, 0.6) << angle << " " << radius;
      }
    }
  }
}

TEST(GenerateDummiesTest, ThinWallDoesNotReachThroughItsOtherFace) {
  Scene scene = empty_scene(2);  // a plate 0.5 m thick: one layer between its faces
  scene.walls = {line_wall("plate", WallKind::no_slip, {{0, 0}, {5, 0}, {5, -0.5}, {0, -0.5}})};
  const WallDummies dummies = generate_dummies(scene);
  EXPECT_EQ(dummies.position.size(), 10U);
  for (const Vec3& p : dummies.position) EXPECT_NEAR(p[1], -0.25, 1e-12);
  expect_consistent(scene, dummies);
}

TEST(GenerateDummiesTest, FirstLayerOfAnUnevenStepKeepsItsDistance) {
  // The crest, 1 m for a spacing of 0.3 m, has a column 0.05 m behind each side face.
  const Scene scene = line_scene({{0, 0}, {3, 0}, {3, 2}, {4, 2}, {4, 0}, {7, 0}}, 0.3);
  const WallDummies dummies = generate_dummies(scene);
  EXPECT_GE(nearest_pair(dummies), 0.15 * (1.0 - 1e-5));
  for (const double distance : dummies.distance) EXPECT_GE(distance, 0.075 - 1e-6);
  expect_consistent(scene, dummies);
}

TEST(GenerateDummiesTest, CornerBelongsToTheNoSlipFaceElseToTheNearestPlane) {
  for (const WallKind side : {WallKind::free_slip, WallKind::no_slip}) {
    Scene scene = empty_scene(2);
    scene.walls = {line_wall("side", side, {{0, 5}, {0, 0}}),
                   line_wall("base", WallKind::no_slip, {{0, 0}, {10, 0}})};
    const WallDummies dummies = generate_dummies(scene);
    std::size_t corner = 0;
    for (std::size_t k = 0; k < dummies.position.size(); ++k) {
      const Vec3& p = dummies.position[k];
      if (p[0] > 0.0) {
        EXPECT_EQ(dummies.wall[k], 1U);
      } else if (p[1] > 0.0) {
        EXPECT_EQ(dummies.wall[k], 0U);
      } else {
        ++corner;
        const bool base = side == WallKind::free_slip || p[1] > p[0];
        if (side == WallKind::no_slip && std::abs(p[0] - p[1]) < 1e-9) continue;  // a tie
        EXPECT_EQ(dummies.wall[k], base ? 1U : 0U);
        EXPECT_NEAR(dummies.distance[k], base ? -p[1] : -p[0], 1e-12);
        EXPECT_EQ(dummies.normal[k], (base ? Vec3{0, 1, 0} : Vec3{1, 0, 0}));
      }
    }
    EXPECT_EQ(corner, 9U);
    expect_consistent(scene, dummies);
  }
}

TEST(GenerateDummiesTest, GateThatGoesLeavesTheBaseWhole) {
  Scene scene = empty_scene(2);
  Wall gate = line_wall("gate", WallKind::no_slip, {{4, 0}, {4, 3}});
  gate.removed_at = "collapse";
  scene.walls = {gate, line_wall("base", WallKind::no_slip, {{0, 0}, {10, 0}})};
  const WallDummies dummies = generate_dummies(scene);
  std::size_t base = 0, standing = 0;
  for (std::size_t k = 0; k < dummies.position.size(); ++k) {
    base += dummies.wall[k] == 1;
    standing += dummies.wall[k] == 0;
    EXPECT_EQ(dummies.wall[k], dummies.position[k][1] < 0.0 ? 1U : 0U);
  }
  EXPECT_EQ(base, 60U);
  EXPECT_EQ(standing, 18U) << "the gate reaches down to the base and no further";
}

TEST(GenerateDummiesTest, GateSunkIntoTheBaseOrAtItsEndLeavesTheBaseWhole) {
  for (const Points2& line : {Points2{{4, -1}, {4, 3}}, Points2{{10, 0}, {10, 3}}}) {
    Scene scene = empty_scene(2);
    Wall gate = line_wall("gate", WallKind::no_slip, line);
    gate.velocity = {0.0, 1.0, 0.0};
    scene.walls = {gate, line_wall("base", WallKind::no_slip, {{0, 0}, {10, 0}})};
    const WallDummies dummies = generate_dummies(scene);
    for (std::size_t k = 0; k < dummies.position.size(); ++k) {
      EXPECT_EQ(dummies.wall[k], dummies.position[k][1] < 0.0 ? 1U : 0U);
    }
    // 20 columns; the gate at the end makes a corner of 3 more.
    const std::size_t below = line[0][0] > 9.0 ? 69U : 60U;
    EXPECT_EQ(dummies.position.size(), below + 18U);
  }
}

TEST(GenerateDummiesTest, SmoothWallsLayNoneAndTakeNone) {
  // However a smooth side meets the base: at its end, going on below it, crossed by it.
  for (const double below : {0.0, 5.0}) {
    for (const double beyond : {0.0, 0.05, 0.25, 1.0, 5.0}) {
      for (const bool swapped : {false, true}) {
        Scene scene = empty_scene(2);
        scene.walls = {line_wall("base", WallKind::no_slip, {{-beyond, 0}, {10, 0}}),
                       line_wall("side", WallKind::free_slip, {{0, 5}, {0, -below}})};
        if (swapped) std::swap(scene.walls[0], scene.walls[1]);
        const WallDummies dummies = generate_dummies(scene);
        double least = 0.0;
        for (std::size_t k = 0; k < dummies.position.size(); ++k) {
          EXPECT_EQ(scene.walls[dummies.wall[k]].name, "base");
          least = std::min(least, dummies.position[k][0]);
        }
        // Full layers as far as the support of soil at the side reaches.
        EXPECT_LE(least, -1.0) << below << ' ' << beyond;
        std::size_t left = 0;
        for (const Vec3& p : dummies.position) left += p[0] < 5.0;
        EXPECT_GE(left, 3U * 12U) << below << ' ' << beyond;
        EXPECT_GE(nearest_pair(dummies), 0.5 - 1e-9);
        expect_consistent(scene, dummies);
      }
    }
  }
}

TEST(GenerateDummiesTest, CornerWithASmoothWallThatGoesIsTold) {
  Scene scene = empty_scene(2);
  scene.walls = {line_wall("plate", WallKind::no_slip, {{10, 3}, {0, 3}}),
                 line_wall("sides", WallKind::free_slip, {{0, 3}, {0, 0}})};
  EXPECT_TRUE(generate_dummies(scene).beside_smooth.empty());
  scene.stages = {Stage{}};
  scene.stages[0].duration = 1.0;
  scene.walls[0].velocity = {0, -1, 0};
  const WallDummies moving = generate_dummies(scene);
  ASSERT_EQ(moving.beside_smooth.size(), 9U);
  for (const SmoothCorner& corner : moving.beside_smooth) {
    EXPECT_LT(moving.position[corner.dummy][0], 0.0);
    EXPECT_EQ(corner.over[0], (Vec3{-1, 0, 0}));
    const CornerReach reach = corner_reach(scene);
    const Vec3& at = moving.position[corner.dummy];
    const auto stands = [&](bool standing, double down) {
      const std::vector<Vec3> offset{{0, -down, 0}, {}};
      const std::vector<bool> stand{true, standing};
      FacetSearch search;
      return stands_in_corner(scene, WallSurface(scene), reach, corner,
                              geometry::plus(at, -down, {0, 1, 0}), {stand, offset}, search);
    };
    EXPECT_TRUE(stands(true, 0.0));
    EXPECT_TRUE(stands(true, 1.0));
    EXPECT_FALSE(stands(true, 12.0)) << "below the sides the plate is as wide as it is drawn";
    EXPECT_FALSE(stands(false, 1.0));
  }
}

TEST(GenerateDummiesTest, OverlappingFacetsAreFilledOnce) {
  Scene scene = empty_scene(2);
  // Sites of the second are in the middle of four of the first, 0.7 of a spacing from each: far
  // enough not to be taken for the same, yet they would double the density of the wall.
  scene.walls = {line_wall("first", WallKind::no_slip, {{0, 0}, {10, 0}}),
                 line_wall("second", WallKind::no_slip, {{0.25, -0.25}, {10.25, -0.25}})};
  EXPECT_EQ(generate_dummies(scene).position.size(), 60U);
}

TEST(GenerateDummiesTest, FreeEdgesAreNotMadeWider) {
  Scene scene = empty_scene(2);  // a footing on soil, its face down
  scene.walls = {line_wall("footing", WallKind::no_slip, {{2, 5}, {0, 5}})};
  for (const Vec3& p : generate_dummies(scene).position) {
    EXPECT_TRUE(p[0] > 0.0 && p[0] < 2.0 && p[1] > 5.0);
  }
}

TEST(GenerateDummiesTest, DummiesNearAFreeEdgeAreKnown) {
  // Three layers see soil up to three columns away.
  const Points2 open{{0, 0}, {4, 0}, {10, 0}}, bent{{0, 9}, {0, 0}, {10, 0}, {10, 9}};
  const WallDummies line = generate_dummies(line_scene(open)),
                    basin = generate_dummies(line_scene(bent));
  ASSERT_EQ(line.position.size(), 60U);
  for (std::size_t k = 0; k < line.position.size(); ++k) {
    const double x = line.position[k][0];
    EXPECT_EQ(line.near_edge[k], x < 1.5 || x > 8.5) << x;
  }
  for (std::size_t k = 0; k < basin.position.size(); ++k) {
    const double y = basin.position[k][1];
    EXPECT_EQ(basin.near_edge[k], y > 7.5) << basin.position[k][0] << ' ' << y;
  }
}

TEST(GenerateDummiesTest, BoxWithOpenTopIsClosedBelow) {
  Scene scene = empty_scene(3);
  Wall wall;
  wall.name = "box";
  wall.facets = box_facets({{0, 0, 0}, {3, 2, 4}}, {"+z"}, 3);
  scene.walls = {wall};
  const WallDummies dummies = generate_dummies(scene);
  const auto held = cells(dummies, 0.5);
  // Outer block of 12 x 10 x 11 cells less the inner of 6 x 4 x 8.
  EXPECT_EQ(dummies.position.size(), 12U * 10U * 11U - 6U * 4U * 8U);
  EXPECT_EQ(held.size(), dummies.position.size());
  for (const auto& [cell, count] : held) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(cell[0] >= -3 && cell[0] < 9 && cell[1] >= -3 && cell[1] < 7);
    EXPECT_TRUE(cell[2] >= -3 && cell[2] < 8);
    EXPECT_FALSE(cell[0] >= 0 && cell[0] < 6 && cell[1] >= 0 && cell[1] < 4 && cell[2] >= 0);
  }
  expect_consistent(scene, dummies);
}

TEST(GenerateDummiesTest, FacetShorterThanASpacingIsRefused) {
  try {
    generate_dummies(line_scene({{0, 0}, {10, 0}, {10, 0.4}}));
    FAIL() << "no error";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("key 'wall[0]' = 'wall': a facet is 0.4 m long"), std::string::npos)
        << message;
  }
}

TEST(GenerateDummiesTest, TooManyAreRefusedBeforeMemoryIsTaken) {
  EXPECT_THROW(generate_dummies(line_scene({{0, 0}, {1e9, 0}}, 1e-9)), SceneError);
}

}  // namespace
}  // namespace scarp::test
