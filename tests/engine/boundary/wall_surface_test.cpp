// SPDX-License-Identifier: BSD-3-Clause
/// What the surface of all walls answers, against asking every face; what a question costs.
#include "engine/boundary/wall_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/engine/boundary/line_walls.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

using geometry::coordinates;
using geometry::cross;
using geometry::dot;
using geometry::minus;
using geometry::plus;

/// Walls of random rectangles, some of which move or go.
struct RandomWalls {
  std::mt19937 random;
  Scene scene = empty_scene(3);
  std::vector<bool> stands;
  std::vector<Vec3> offset, offset_before;

  explicit RandomWalls(unsigned seed) : random(seed) {
    scene.stages = {stage_for("one", 1.0), stage_for("two", 1.0)};
    const Vec3 velocities[] = {{}, {}, {1, 0, 0}, {0, 2, -1}};
    const char* const begins[] = {"", "one", "two"};
    for (std::size_t w = 0; w < 24; ++w) {
      Wall wall = wall_of("wall " + std::to_string(w), WallKind::no_slip, {});
      wall.velocity = velocities[random() % 4];
      const std::size_t begin = random() % 3;
      wall.moves_from = begins[begin];
      const std::size_t count = 1 + random() % 12;
      for (std::size_t f = 0; f < count; ++f) wall.facets.push_back(facet());
      scene.walls.push_back(wall);
      stands.push_back(random() % 8 != 0);
      const double since = wall.velocity == Vec3{} ? 0.0 : 3.0 - static_cast<double>(begin);
      offset.push_back(plus({}, since, wall.velocity));
      offset_before.push_back(plus({}, since - 0.3, wall.velocity));
    }
  }

  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  }
  Vec3 point(double size) {
    return {number(-size, size), number(-size, size), number(-size, size)};
  }
  Vec3 direction() {
    const Vec3 any = point(1.0);
    return plus({}, 1.0 / std::sqrt(dot(any, any)), any);
  }
  Facet facet() {
    const Vec3 u = direction(), across = cross(direction(), u);
    const Vec3 v = plus({}, 1.0 / std::sqrt(dot(across, across)), across);
    return {point(10.0), u, v, number(0.5, 6.0), number(0.5, 6.0), cross(u, v)};
  }
};

bool holds(std::span<const std::uint32_t> found, std::uint32_t face) {
  return std::binary_search(found.begin(), found.end(), face);
}

/// A level base from -500 to 500 spacings in so many pieces.
Wall base_in(int pieces, WallKind kind, double spacing) {
  Points2 points;
  for (int k = 0; k <= pieces; ++k) points.push_back({(1000.0 * k / pieces - 500.0) * spacing, 0});
  return line_wall("base", kind, points);
}

TEST(WallSurfaceTest, NamesEveryStandingFaceWithinReachInOrder) {
  for (const unsigned seed : {1U, 2U, 3U}) {
    RandomWalls walls(seed);
    const WallSurface surface(walls.scene);
    const WallPlacement placement{walls.stands, walls.offset};
    FacetSearch search;
    std::size_t near = 0;
    for (int k = 0; k < 1500; ++k) {
      const Vec3 point = walls.point(12.0);
      const double reach = walls.number(0.0, 3.0);
      const auto found = surface.near(point, reach, placement, search);
      ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
      for (std::uint32_t face = 0; face < surface.faces().size(); ++face) {
        const auto& [facet, w] = surface.faces()[face];
        const double distance =
            coordinates(facet, 3, minus(point, walls.offset[w])).distance(facet);
        if (!walls.stands[w]) {
          ASSERT_FALSE(holds(found, face));
        } else if (distance <= reach) {
          ++near;
          ASSERT_TRUE(holds(found, face)) << face << " at " << distance << " of " << reach;
        }
      }
    }
    EXPECT_GT(near, 500U) << "the test looks past the walls";
  }
}

TEST(WallSurfaceTest, AFewFacesAreNamedAtOnceWithoutThoseThatHaveGone) {
  Scene scene = empty_scene(2);
  scene.walls = {base_in(3, WallKind::no_slip, 0.5), base_in(2, WallKind::no_slip, 0.5)};
  const WallSurface few(scene);
  EXPECT_EQ(few.all_if_few({true, true}), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(few.all_if_few({false, true}), (std::vector<std::uint32_t>{3, 4}));
  scene.walls[0] = base_in(1000, WallKind::no_slip, 0.5);
  EXPECT_TRUE(WallSurface(scene).all_if_few({true, true}).empty());
}

TEST(WallSurfaceTest, TheNearestPointIsThatOfTheNearestFace) {
  RandomWalls walls(4);
  const WallSurface surface(walls.scene);
  FacetSearch search;
  int without = 0;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 point = walls.point(12.0);
    const double reach = walls.number(0.2, 2.0);
    const auto skipped = static_cast<std::uint32_t>(walls.random() % surface.faces().size());
    double least = reach;
    std::uint32_t nearest = skipped;
    for (std::uint32_t face = 0; face < surface.faces().size(); ++face) {
      const double distance =
          coordinates(surface.facet(face), 3, point).distance(surface.facet(face));
      if (face == skipped || distance > least) continue;
      least = distance;
      nearest = face;
    }
    const WallSurface::Nearest found = surface.nearest(point, reach, skipped, search);
    ASSERT_EQ(std::isfinite(found.distance), nearest != skipped);
    without += nearest == skipped ? 1 : 0;
    if (nearest == skipped) continue;
    ASSERT_EQ(found.face, nearest);
    ASSERT_EQ(found.distance, least);
    // Some twenty roundings of coordinates up to 12.
    const Vec3 way = minus(found.point, point);
    ASSERT_NEAR(std::sqrt(dot(way, way)), least, 20 * 12 * 2.2e-16);
  }
  EXPECT_GT(without, 50);
  EXPECT_LT(without, 950);
}

TEST(WallSurfaceTest, NamesEveryFaceThatAWayPasses) {
  RandomWalls walls(5);
  const WallSurface surface(walls.scene);
  const WallPlacement placement{walls.stands, walls.offset};
  FacetSearch search;
  int passed = 0;
  for (int k = 0; k < 6000; ++k) {
    const Vec3 before = walls.point(12.0), now = plus(before, 2.0, walls.direction());
    const double depth = walls.number(0.0, 0.5);
    const auto found =
        surface.on_way(before, walls.offset_before, now, placement, depth * (1.0 + 1e-6), search);
    ASSERT_TRUE(std::is_sorted(found.begin(), found.end()));
    for (std::uint32_t face = 0; face < surface.faces().size(); ++face) {
      const auto& [facet, w] = surface.faces()[face];
      if (!geometry::goes_in(facet, 3, minus(before, walls.offset_before[w]),
                             minus(now, walls.offset[w]), depth))
        continue;
      passed += walls.stands[w] ? 1 : 0;
      ASSERT_EQ(holds(found, face), walls.stands[w]);
    }
  }
  EXPECT_GT(passed, 200);
}

TEST(WallSurfaceTest, AFacetFindsThoseWithinReachOfIt) {
  RandomWalls walls(6);
  const WallSurface surface(walls.scene);
  FacetSearch search;
  for (std::uint32_t own = 0; own < surface.faces().size(); ++own) {
    const Facet& facet = surface.facet(own);
    const auto found = surface.near(facet, 0.5, search);
    EXPECT_TRUE(holds(found, own));
    for (std::uint32_t face = 0; face < surface.faces().size(); ++face) {
      for (const Vec3& corner : geometry::corners(facet, 3)) {
        const double distance =
            coordinates(surface.facet(face), 3, corner).distance(surface.facet(face));
        if (distance <= 0.5) {
          ASSERT_TRUE(holds(found, face));
        }
      }
    }
  }
}

/// Boxes that one question may look at: a box two pieces wide meets two boxes of each level of the
/// tree, whose four children are looked at; then the four facets in each of two leaves.
double most_boxes(int pieces) {
  return 1.0 + 4.0 * std::ceil(std::log2(std::max(pieces / 4.0, 1.0))) + 8.0;
}

/// A bed that spreads over the base.
Scene spreading_bed(int pieces, WallKind kind) {
  Scene scene;
  scene.spacing = 0.125;  // places of dummies and images come out without rounding
  scene.numerics = preset("modern");
  scene.materials = {clay()};
  scene.bodies = {{.shape = Box{{-1, 0, 0}, {1, 1, 0}}, .velocity = {2, 0, 0}}};
  scene.walls = {base_in(pieces, kind, scene.spacing)};
  scene.initial_stress = InitialStress::geostatic;
  scene.stages = {stage_for("spread", 1.0)};
  return scene;
}

TEST(WallSurfaceTest, ABaseInPiecesHoldsABedAsOneBaseDoes) {
  for (const WallKind kind : {WallKind::no_slip, WallKind::free_slip}) {
    const Scene whole = spreading_bed(1, kind);
    const Simulation wanted = run_steps(whole, 200);
    const std::vector<double> expected = wanted.field("position");
    for (const int pieces : {10, 1000}) {
      const Simulation cut = run_steps(spreading_bed(pieces, kind), 200);
      const std::vector<double> position = cut.field("position");
      EXPECT_EQ(cut.wall_count(), wanted.wall_count());
      ASSERT_EQ(position.size(), expected.size());
      for (std::size_t k = 0; k < position.size(); ++k) {
        // Round-off of a step is 1e-16 of lengths of 1 m; 200 steps may multiply it a thousandfold.
        ASSERT_NEAR(position[k], expected[k], 1e-13) << pieces << " pieces, value " << k;
      }
    }
  }
}

TEST(WallSurfaceTest, AQuestionCostsTheSameForAnyNumberOfFaces) {
  constexpr double spacing = 0.125;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> along(-60.0, 60.0), up(-0.05, 1.0);
  for (const int pieces : {1, 10, 1000, 100000}) {
    // From 1000 pieces on they are a spacing long, and the base grows.
    const double piece = std::max(1000.0 / pieces, 1.0) * spacing;
    Points2 points;
    for (int k = 0; k <= pieces; ++k) points.push_back({(k - pieces / 2) * piece, 0});
    Scene scene = empty_scene(2);
    scene.walls = {line_wall("base", WallKind::no_slip, points)};
    const WallSurface surface(scene);
    const std::vector<bool> stands{true};
    const std::vector<Vec3> offset{Vec3{}};
    const WallPlacement placement{stands, offset};
    for (int k = 0; k < 2000; ++k) {
      const Vec3 point{along(random), up(random), 0.0};
      FacetSearch search;
      EXPECT_LE(surface.near(point, 0.5 * spacing, placement, search).size(), 3U);
      EXPECT_LE(static_cast<double>(search.looked_at), most_boxes(pieces));
      search.looked_at = 0;
      const Vec3 now = plus(point, 0.3 * spacing, {0.6, -0.8, 0.0});
      EXPECT_LE(surface.on_way(point, offset, now, placement, 0.3 * spacing, search).size(), 3U);
      EXPECT_LE(static_cast<double>(search.looked_at), most_boxes(pieces));
    }
  }
}

}  // namespace
}  // namespace scarp::test
