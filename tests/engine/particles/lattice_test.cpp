// SPDX-License-Identifier: BSD-3-Clause
/// Lattice points on the faces of bodies, and bodies turned against the lattice.
#include "engine/particles/lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/filled_bodies.hpp"

namespace scarp {
namespace {

using test::fill;

/// A parallelogram along `u` and `v` from `corner`, all in spacings of 0.1 m.
Polygon parallelogram(std::array<double, 2> corner, std::array<double, 2> u,
                      std::array<double, 2> v) {
  Polygon polygon;
  for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
    polygon.points.push_back(
        {0.1 * (corner[0] + a * u[0] + b * v[0]), 0.1 * (corner[1] + a * u[1] + b * v[1])});
  return polygon;
}

/// Particles of the last body; the first, one cell, places the lattice.
std::size_t held(int dimension, const Body::Shape& shape, double x = 0.0) {
  const Body cell{.shape = Box{{x - 10.0, -10.0, -10.0}, {x - 9.9, -9.9, -9.9}}};
  return fill(dimension, 0.1, {cell, {.shape = shape}}).position.size() - 1;
}

// Copies of a parallelogram whose edges are whole numbers of spacings tile the plane, and the
// lattice looks the same from each: if none of them share a point and none is left over, each holds
// as many points as its area has cells, wherever it stands.
TEST(LatticeTest, ParallelogramsOfWholeSpacingsHoldTheirAreaExactlyWhereverTheyStand) {
  using Edge = std::array<double, 2>;
  const std::vector<std::pair<Edge, Edge>> edges = {
      {{7, 0}, {0, 5}}, {{6, 6}, {-6, 6}}, {{20, 20}, {-3, 3}}, {{9, 9}, {-4, 0}},
      {{8, 0}, {5, 5}}, {{8, 4}, {-3, 6}}, {{3, 9}, {-6, 2}},   {{1, 30}, {-6, 0}}};
  for (const auto& [u, v] : edges) {
    const auto area = static_cast<std::size_t>(u[0] * v[1] - u[1] * v[0]);
    // Points on corners, on edges, a rounding beside them, and elsewhere.
    for (const double x : {0.5, 0.0, 0.25, 0.5 + 9e-10, 0.5 - 9e-10, 0.37}) {
      for (const double y : {0.5, 0.0, 0.5 + 9e-10, 0.5 - 9e-10, 0.61}) {
        const Polygon polygon = parallelogram({x, y}, u, v);
        EXPECT_EQ(held(2, polygon), area) << u[0] << " " << u[1] << " at " << x << " " << y;
        Polygon solid = polygon;
        solid.extrude = {0.1 * x, 0.1 * x + 0.4};
        EXPECT_EQ(held(3, solid), 4 * area) << u[0] << " " << u[1] << " at " << x << " " << y;
      }
    }
  }
}

TEST(LatticeTest, BoxesBetweenTwoRowsOfPointsHoldOneOfThem) {
  for (const double at : {0.05, 0.0, 0.05 + 9e-11, 0.05 - 9e-11}) {
    EXPECT_EQ(held(2, Box{{at, at, 0}, {at + 0.7, at + 0.5, 0}}), 35U) << at;
    EXPECT_EQ(held(3, Box{{at, at, at}, {at + 0.7, at + 0.5, at + 0.3}}), 105U) << at;
    HeightField field{{at, at}, {at + 0.7, at + 0.5}, at, HeightField::Kind::x_profile, {}, {}, ""};
    field.profile = {{0, at + 0.3}, {1, at + 0.3}};
    EXPECT_EQ(held(3, field), 105U) << at;
  }
  // Far away, where round-off is more than a billionth of a spacing.
  const double x = 4.2e6;
  const Polygon turned{{{x, 0}, {x + 0.6, 0.6}, {x, 1.2}, {x - 0.6, 0.6}}, {}};
  EXPECT_EQ(held(2, turned, x), 72U);
}

TEST(LatticeTest, FacesThroughPointsHoldThemIfTheyLookUp) {
  // Half of the cells on the face of 1 to 1 too many, as many as without the points too few.
  constexpr std::size_t n = 20;
  const Polygon right{{{0, 0}, {2, 0}, {0, 2}}, {}}, left{{{0, 0}, {2, 0}, {2, 2}}, {}};
  const Polygon overhang{{{0, 0}, {2, 2}, {0, 2}}, {}};
  EXPECT_EQ(held(2, right), n * (n + 1) / 2);
  EXPECT_EQ(held(2, left), n * (n + 1) / 2);
  EXPECT_EQ(held(2, overhang), n * (n - 1) / 2);
}

TEST(LatticeTest, PointsOnASharedFaceBelongToTheSameBodyInAnyOrder) {
  const Body lower{.shape = Polygon{{{0, 0}, {2, 0}, {2, 2}}, {0, 0.3}}};
  // Each has a half of the face.
  const Body left{.shape = Polygon{{{0, 0}, {1, 1}, {0, 2}}, {0, 0.3}}, .material = "rock"};
  const Body right{.shape = Polygon{{{1, 1}, {2, 2}, {0, 2}}, {0, 0.3}}, .material = "rock"};
  for (const int dimension : {2, 3}) {
    const std::size_t deep = dimension == 3 ? 3 : 1;
    for (std::vector<Body> bodies :
         {std::vector{lower, left, right}, {left, right, lower}, {right, lower, left}}) {
      bodies.insert(bodies.begin(), {.shape = Box{{-1, -1, -1}, {-0.9, -0.9, -0.9}}});
      const Particles soil = fill(dimension, 0.1, bodies);
      ASSERT_EQ(soil.position.size(), deep * 400U + 1U);
      const auto rock = std::count(soil.material.begin(), soil.material.end(), 1);
      EXPECT_EQ(static_cast<std::size_t>(rock), deep * 190U);
    }
  }
}

TEST(LatticeTest, RoundBodiesKeepTheirSymmetry) {
  // Centre on a point, radius of five spacings: (3, 4), (4, 3), (5, 0) and their mirrors are on it.
  EXPECT_EQ(held(2, Cylinder{{0.05, 0.05, 0}, 0.5, 0.0, 0.0}), 81U);
  EXPECT_EQ(held(3, Cylinder{{0.05, 0.05, 0.05}, 0.5, 0.0, 0.3}), 3 * 81U);
}

/// A rectangle turned about the origin.
Polygon turned(double width, double height, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180.0),
               s = std::sin(degrees * std::numbers::pi / 180.0);
  Polygon polygon{{}, {0.0, 0.3}};
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {width, 0.0}, {width, height}, {0.0, height}})
    polygon.points.push_back({c * x - s * y, s * x + c * y});
  return polygon;
}

TEST(LatticeTest, ATurnedLayerHoldsItsMassToHalfARow) {
  // At 45 degrees rows are dx/sqrt(2) apart: 14.1 and 28.3 of them in a layer 1 m deep, of which 15
  // and 29 fit in.
  for (const double spacing : {0.1, 0.05, 0.025}) {
    for (const double degrees : {15.0, 30.0, 45.0, -45.0, 60.0}) {
      const Polygon layer = turned(16.0, 1.0, degrees);
      const Particles plane = fill(2, spacing, {{.shape = layer}});
      const double row = spacing / std::numbers::sqrt2;
      const auto held = static_cast<double>(plane.position.size()) * spacing * spacing;
      EXPECT_NEAR(held, 16.0, 16.0 * 0.5 * row) << spacing << " " << degrees;
      const Particles solid = fill(3, spacing, {{.shape = layer}});
      EXPECT_EQ(solid.position.size(), std::lround(0.3 / spacing) * plane.position.size());
    }
  }
}

TEST(LatticeTest, ATurnedBodyIsMovedToTheLatticeOnlyWhereRowsRunAlongItsEdges) {
  const auto lowest = [](const Polygon& polygon) {
    const Particles soil = fill(2, 0.1, {{.shape = polygon}});
    double x = 1e9, left = 1e9;
    for (const Vec3& p : soil.position) x = std::min(x, p[0]);
    for (const auto& p : polygon.points) left = std::min(left, p[0]);
    return (x - left) / 0.1 - 0.5;
  };
  const auto is_whole = [](double value) { return std::abs(value - std::round(value)) < 1e-6; };
  EXPECT_TRUE(is_whole(lowest(turned(16.0, 1.0, 30.0))));
  EXPECT_TRUE(is_whole(lowest(turned(3.0, 3.0, 45.0))));  // 42.4 rows, of which 43 and 42 fit in
  EXPECT_FALSE(is_whole(lowest(turned(16.0, 1.0, 45.0))));
  // An edge along an axis is met instead.
  Polygon wedge = turned(16.0, 1.0, 45.0);
  wedge.points[3][1] = wedge.points[2][1];
  EXPECT_TRUE(is_whole(lowest(wedge)));
}

}  // namespace
}  // namespace scarp
