// SPDX-License-Identifier: BSD-3-Clause
/// Rows of the list of shapes: cuts along every axis against a test of single points.
#include "engine/scene/shape_list.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace scarp {
namespace {

/// Whether a point is inside, from the definition of the shape alone.
using Holds = bool (*)(const Body::Shape& shape, const Vec3& p);

bool box_holds(const Body::Shape& shape, const Vec3& p) {
  const Box& box = std::get<Box>(shape);
  for (std::size_t a = 0; a < 3; ++a) {
    if (p[a] < box.minimum[a] || p[a] > box.maximum[a]) return false;
  }
  return true;
}

bool ring_holds(const Body::Shape& shape, const Vec3& p) {
  const Cylinder& c = std::get<Cylinder>(shape);
  const double radius = std::hypot(p[0] - c.centre[0], p[1] - c.centre[1]);
  return radius >= c.inner_radius && radius <= c.radius && p[2] >= c.centre[2] &&
         p[2] <= c.centre[2] + c.height;
}

/// By the angle under which the outline goes round the point.
bool goes_round(const std::vector<std::array<double, 2>>& points, double x, double y) {
  double angle = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto &a = points[i], &b = points[(i + 1) % points.size()];
    const double ax = a[0] - x, ay = a[1] - y, bx = b[0] - x, by = b[1] - y;
    angle += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return std::abs(angle) > 3.0;
}

bool outline_holds(const Body::Shape& shape, const Vec3& p) {
  return goes_round(std::get<Polygon>(shape).points, p[0], p[1]);
}

bool prism_holds(const Body::Shape& shape, const Vec3& p) {
  const Polygon& polygon = std::get<Polygon>(shape);
  return p[1] >= polygon.extrude[0] && p[1] <= polygon.extrude[1] &&
         goes_round(polygon.points, p[0], p[2]);
}

bool hill_holds(const Body::Shape& shape, const Vec3& p) {
  const HeightField& field = std::get<HeightField>(shape);
  const double distance = std::hypot(p[0] - field.centre[0], p[1] - field.centre[1]);
  const double height = std::max(4.0 - distance, 1.0);  // what the profile below says
  return p[0] >= field.plan_minimum[0] && p[0] <= field.plan_maximum[0] &&
         p[1] >= field.plan_minimum[1] && p[1] <= field.plan_maximum[1] && p[2] >= field.base &&
         p[2] <= height;
}

struct Example {
  const char* name;
  int dimension;
  Body::Shape shape;
  Holds holds;
};

const std::vector<Example>& examples() {
  const std::vector<std::array<double, 2>> hook{{0, 0}, {5, 0},   {5, 4}, {3, 4},
                                                {3, 2}, {1.5, 2}, {2, 5}, {-1, 3}};
  static const std::vector<Example> all{
      {"rectangle", 2, Box{{-1, 0, 0}, {3, 2, 0}}, box_holds},
      {"box", 3, Box{{-1, 0, 1}, {3, 2, 5}}, box_holds},
      {"disc", 2, Cylinder{{1, 2, 0}, 2.0, 0.0, 0.0}, ring_holds},
      {"ring", 2, Cylinder{{1, 2, 0}, 3.0, 1.2, 0.0}, ring_holds},
      {"tube", 3, Cylinder{{1, 2, -1}, 3.0, 1.2, 4.0}, ring_holds},
      {"hook", 2, Polygon{hook, {}}, outline_holds},
      {"prism", 3, Polygon{hook, {-1, 2}}, prism_holds},
      {"hill", 3,
       HeightField{
           {-3, -2}, {4, 3}, 0.5, HeightField::Kind::radial_profile, {1, 0}, {{0, 4}, {3, 1}}, {}},
       hill_holds}};
  return all;
}

TEST(ShapeListTest, RowsStandInTheOrderOfTheAlternativesUnderKeysOfTheirOwn) {
  std::set<std::string_view> keys;
  for (const ShapeRow* row : shape_list()) EXPECT_TRUE(keys.insert(row->key).second) << row->key;
  EXPECT_EQ(row_of(Polygon{}).key, "polygon");
  EXPECT_EQ(row_of(Box{}).key, "box");
  EXPECT_EQ(row_of(Cylinder{}).key, "cylinder");
  EXPECT_EQ(row_of(HeightField{}).key, "height_field");
}

TEST(ShapeListTest, CutsAlongEveryAxisHoldThePointsInside) {
  std::mt19937 random(3);
  for (const Example& example : examples()) {
    const ShapeRow& row = row_of(example.shape);
    const ShapeExtent extent = row.extent(example.shape, example.dimension);
    const ShapeCut cut = row.cut(example.shape, example.dimension, 1e-9, example.name);
    const std::size_t up = example.dimension == 2 ? 1 : 2;
    const auto number = [&](std::size_t a) {
      return std::uniform_real_distribution<double>(extent.minimum[a], extent.maximum[a])(random);
    };
    int inside = 0;
    for (std::size_t axis = 0; axis <= up; ++axis) {
      if (row.only_vertical && axis != up) continue;
      for (int line = 0; line < 200; ++line) {
        Vec3 point{};
        for (std::size_t a = 0; a <= up; ++a) point[a] = number(a);
        std::vector<Range> ranges;
        cut(axis, point, ranges);
        for (int k = 0; k < 20; ++k) {
          // Beyond the shape as well.
          point[axis] = 1.2 * number(axis) - 0.1 * (extent.minimum[axis] + extent.maximum[axis]);
          const bool held = std::any_of(ranges.begin(), ranges.end(), [&](const Range& range) {
            return within(point[axis], range.low, range.high);
          });
          EXPECT_EQ(held, example.holds(example.shape, point))
              << example.name << " along axis " << axis << " at " << point_text(point, 3);
          inside += held ? 1 : 0;
        }
      }
    }
    EXPECT_GT(inside, 300) << example.name;
  }
}

TEST(ShapeListTest, TheExtentIsTheSmallestBoxAroundTheCuts) {
  for (const Example& example : examples()) {
    const ShapeRow& row = row_of(example.shape);
    const ShapeExtent extent = row.extent(example.shape, example.dimension);
    const ShapeCut cut = row.cut(example.shape, example.dimension, 1e-9, example.name);
    const std::size_t up = example.dimension == 2 ? 1 : 2;
    constexpr int steps = 400;  // even: the middle is on a line
    double low = 1e9, high = -1e9;
    for (int i = 0; i <= steps; ++i) {
      for (int j = 0; j <= (up == 2 ? steps : 0); ++j) {
        const auto at = [&](std::size_t a, int k) {
          return extent.minimum[a] + (extent.maximum[a] - extent.minimum[a]) * k / steps;
        };
        std::vector<Range> ranges;
        cut(up, {at(0, i), up == 2 ? at(1, j) : 0.0, 0.0}, ranges);
        for (const Range& range : ranges) {
          low = std::min(low, range.low);
          high = std::max(high, range.high);
        }
      }
    }
    // A curved or slanting top is met at best between two lines, which are at most 0.02 apart.
    EXPECT_NEAR(low, extent.minimum[up], 0.05) << example.name;
    EXPECT_NEAR(high, extent.maximum[up], 0.05) << example.name;
  }
}

TEST(ShapeListTest, CornersAreInTheExtentAndReachItsEnds) {
  for (const Example& example : examples()) {
    const ShapeRow& row = row_of(example.shape);
    const ShapeExtent extent = row.extent(example.shape, example.dimension);
    for (std::size_t axis = 0; axis < static_cast<std::size_t>(example.dimension); ++axis) {
      if (row.only_vertical && axis == 2) continue;
      std::vector<double> corners;
      row.corners(example.shape, example.dimension, axis, corners);
      ASSERT_FALSE(corners.empty());
      const auto [low, high] = std::minmax_element(corners.begin(), corners.end());
      EXPECT_EQ(*low, extent.minimum[axis]) << example.name;
      EXPECT_EQ(*high, extent.maximum[axis]) << example.name;
    }
  }
}

}  // namespace
}  // namespace scarp
