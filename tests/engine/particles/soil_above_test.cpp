// SPDX-License-Identifier: BSD-3-Clause
/// The weight above: layers, gaps, overhangs and every direction of gravity.
#include "engine/particles/soil_above.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/errors.hpp"

namespace scarp {
namespace {

constexpr double g = 9.81;

std::string name_of(std::size_t material) { return "soil " + std::to_string(material); }

Scene scene_of(int dimension, double spacing, const std::vector<double>& densities,
               std::vector<Body> bodies) {
  Scene scene;
  scene.dimension = dimension;
  scene.spacing = spacing;
  scene.gravity = dimension == 2 ? Vec3{0.0, -g, 0.0} : Vec3{0.0, 0.0, -g};
  for (const double density : densities) {
    scene.materials.push_back({name_of(scene.materials.size()), LinearElastic{20e6, 0.3}, density});
  }
  scene.bodies = std::move(bodies);
  return scene;
}

Body box(std::size_t material, const Vec3& minimum, const Vec3& maximum) {
  return {.shape = Box{minimum, maximum}, .material = name_of(material)};
}

/// Calls check(position, above) for each particle.
template <class Check>
void for_each(const Scene& scene, Check&& check) {
  const Particles soil = generate_soil(scene);
  const std::vector<SoilAbove> above = soil_above(scene, soil, 2);
  ASSERT_EQ(above.size(), soil.position.size());
  for (std::size_t i = 0; i < above.size(); ++i) check(soil.position[i], above[i]);
}

TEST(SoilAboveTest, InOneSoilIsItsDepth) {
  const Polygon slope{{{0, 0}, {45, 0}, {45, 5}, {32, 5}, {12, 15}, {0, 15}}, {}};
  for_each(scene_of(2, 0.25, {2000.0}, {{.shape = slope}}), [](const Vec3& x, const SoilAbove& a) {
    const double surface = std::clamp(0.5 * (42.0 - x[0]), 5.0, 15.0);
    // The top particle stands for the surface to half a spacing.
    EXPECT_NEAR(a.thickness, surface - x[1], 0.125 + 1e-12);
    if (x[0] < 12.0) {
      EXPECT_NEAR(a.thickness, 15.0 - x[1], 1e-12);
    }
    EXPECT_EQ(a.pressure, 2000.0 * g * a.thickness);  // one product: no sum that rounds
  });
}

TEST(SoilAboveTest, FollowsGravityAlongAnyAxisAndSense) {
  Scene scene = scene_of(3, 0.5, {1000.0}, {box(0, {0, 0, 0}, {2, 3, 4})});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sense : {-1.0, 1.0}) {
      scene.gravity = {};
      scene.gravity[axis] = sense * g;
      const double top = sense < 0.0 ? 2.0 + static_cast<double>(axis) : 0.0;
      for_each(scene, [&](const Vec3& x, const SoilAbove& a) {
        EXPECT_NEAR(a.pressure, 1000.0 * g * std::abs(top - x[axis]), 1e-8);
      });
    }
  }
}

TEST(SoilAboveTest, WithoutGravityIsZero) {
  Scene scene = scene_of(2, 0.5, {1000.0}, {box(0, {0, 0, 0}, {2, 2, 0})});
  scene.gravity = {};
  for_each(scene, [](const Vec3&, const SoilAbove& a) {
    EXPECT_EQ(a.pressure, 0.0);
    EXPECT_EQ(a.thickness, 0.0);
  });
}

TEST(SoilAboveTest, LayersWeighWhatTheyAre) {
  // Light soil over rock, and heavy soil in a pit of it; listed in any order.
  const Scene scene = scene_of(
      2, 0.5, {2600.0, 1000.0, 1800.0},
      {box(2, {1, 3, 0}, {2, 5, 0}), box(0, {0, 0, 0}, {4, 5, 0}), box(1, {0, 5, 0}, {4, 10, 0})});
  for_each(scene, [](const Vec3& x, const SoilAbove& a) {
    const double y = x[1], pit = x[0] > 1.0 && x[0] < 2.0 ? 3.0 : 5.0;
    const double expected =
        g * (1000.0 * (10.0 - std::max(y, 5.0)) + 1800.0 * (5.0 - std::clamp(y, pit, 5.0)) +
             2600.0 * (pit - std::min(y, pit)));
    EXPECT_NEAR(a.pressure, expected, 1e-8);
    EXPECT_NEAR(a.thickness, 10.0 - y, 1e-12);
  });
}

TEST(SoilAboveTest, WhatHangsInTheAirCarriesNothingOntoWhatLiesBelow) {
  for (const double gap : {0.2, 10.0}) {
    const Scene scene =
        scene_of(2, 0.1, {2000.0, 2600.0},
                 {box(0, {0, 0, 0}, {6, 1, 0}), box(1, {2.5, 1.0 + gap, 0}, {3.5, 2.0 + gap, 0})});
    for_each(scene, [gap](const Vec3& x, const SoilAbove& a) {
      const bool bed = x[1] < 1.0;
      const double depth = bed ? 1.0 - x[1] : 2.0 + gap - x[1];
      EXPECT_NEAR(a.pressure, (bed ? 2000.0 : 2600.0) * g * depth, 1e-8);
    });
  }
}

TEST(SoilAboveTest, AnOverhangCarriesItsOwnColumn) {
  // A niche 4 m deep and 2 m high under a roof that hangs on the wall behind.
  const Polygon cliff{{{0, 0}, {10, 0}, {10, 3}, {6, 3}, {6, 5}, {10, 5}, {10, 8}, {0, 8}}, {}};
  for_each(scene_of(2, 0.5, {2000.0}, {{.shape = cliff}}), [](const Vec3& x, const SoilAbove& a) {
    const double top = x[0] > 6.0 && x[1] < 4.0 ? 3.0 : 8.0;
    EXPECT_NEAR(a.pressure, 2000.0 * g * (top - x[1]), 1e-8);
  });
}

TEST(SoilAboveTest, AHeightFieldOverRockIn3D) {
  HeightField field{{0, 0}, {8, 3}, 2.0, HeightField::Kind::x_profile, {}, {{0, 6}, {8, 6}}, {}};
  const Scene scene =
      scene_of(3, 0.5, {1900.0, 2600.0},
               {box(1, {0, 0, 0}, {8, 3, 2}), {.shape = field, .material = name_of(0)}});
  for_each(scene, [](const Vec3& x, const SoilAbove& a) {
    const double expected =
        g * (1900.0 * (6.0 - std::max(x[2], 2.0)) + 2600.0 * (2.0 - std::min(x[2], 2.0)));
    EXPECT_NEAR(a.pressure, expected, 1e-8);
  });
}

// Oblique gravity. The ends of a ray are found to dx/512, twice in a layered one.

TEST(SoilAboveTest, ObliqueGravityCountsTheWayToTheSurfaceAlongIt) {
  const double dx = 0.25, tilt = 0.5, s = std::sin(tilt), c = std::cos(tilt);
  Scene scene = scene_of(2, dx, {1800.0, 2500.0},
                         {box(0, {0, 1, 0}, {6, 3, 0}), box(1, {0, 0, 0}, {6, 1, 0})});
  scene.gravity = {g * s, -g * c, 0.0};
  for_each(scene, [&](const Vec3& x, const SoilAbove& a) {
    // Up the ray (-s, c) to the top face or out of the left one.
    const double thickness = std::min((3.0 - x[1]) / c, x[0] / s);
    const double below = std::min(std::max(1.0 - x[1], 0.0) / c, thickness);
    const double expected = g * (2500.0 * below + 1800.0 * (thickness - below));
    EXPECT_NEAR(a.thickness, thickness, dx / 512.0);
    EXPECT_NEAR(a.pressure, expected, 2500.0 * g * 2.0 * dx / 512.0);
  });
}

TEST(SoilAboveTest, ObliqueGravityStopsAtAGapIn3D) {
  const double dx = 0.5;
  Scene scene = scene_of(3, dx, {1800.0, 2500.0},
                         {box(0, {0, 0, 0}, {4, 4, 2}), box(1, {-9, 0, 4}, {4, 4, 5})});
  scene.gravity = {g * 0.6, 0.0, -g * 0.8};
  for_each(scene, [&](const Vec3& x, const SoilAbove& a) {
    const bool bed = x[2] < 3.0;
    const double thickness =
        std::min(((bed ? 2.0 : 5.0) - x[2]) / 0.8, (x[0] + (bed ? 0.0 : 9.0)) / 0.6);
    EXPECT_NEAR(a.pressure, (bed ? 1800.0 : 2500.0) * g * thickness, 2500.0 * g * dx / 512.0);
  });
}

/// Faces along gravity and ground across it cut the lattice in steps; the rays see the faces.
TEST(SoilAboveTest, ASceneTurnedWithItsGravityKeepsItsWeights) {
  const double turn = 0.3, s = std::sin(turn), c = std::cos(turn), dx = 0.25;
  const auto turned = [&](double x, double y) {
    return std::array<double, 2>{c * x - s * y, s * x + c * y};
  };
  const Polygon block{{turned(0, 0), turned(8, 0), turned(8, 6), turned(4, 6), turned(0, 4)}, {}};
  Scene scene = scene_of(2, dx, {2000.0}, {{.shape = block}});
  scene.gravity = {s * g, -c * g, 0.0};
  for_each(scene, [&](const Vec3& x, const SoilAbove& a) {
    const double across = c * x[0] + s * x[1], up = -s * x[0] + c * x[1];
    const double surface = std::min(4.0 + 0.5 * across, 6.0);
    EXPECT_NEAR(a.thickness, surface - up, dx / 512.0 + 1e-6);
  });
}

TEST(SoilAboveTest, AlmostStraightGravityIsThatAlongTheAxis) {
  Scene scene = scene_of(2, 0.5, {1000.0, 2600.0},
                         {box(0, {0, 5, 0}, {4, 8, 0}), box(1, {0, 0, 0}, {4, 5, 0})});
  const Particles soil = generate_soil(scene);
  const std::vector<SoilAbove> straight = soil_above(scene, soil, 1);
  scene.gravity[0] = 1e-7;
  const std::vector<SoilAbove> oblique = soil_above(scene, soil, 1);
  for (std::size_t i = 0; i < straight.size(); ++i) {
    EXPECT_NEAR(oblique[i].pressure, straight[i].pressure, 2600.0 * g * 2.0 * 0.5 / 512.0);
  }
}

TEST(SoilAboveTest, AHeightThatCannotBeFoundOnARayIsAnError) {
  // Finite at the lattice's points, at x = 0.25, 0.75 ..., but not in between.
  HeightField field{{0, 0}, {4, 4}, 0.0, HeightField::Kind::expression, {}, {}, {}};
  field.expression = "abs(rint(2*x - 0.5) - (2*x - 0.5)) < 0.01 ? 3 : 1/0";
  Scene scene = scene_of(3, 0.5, {2000.0}, {{.shape = field}});
  const Particles soil = generate_soil(scene);
  scene.gravity = {3.0, 0.0, -9.0};
  EXPECT_THROW(soil_above(scene, soil, 2), SceneError);
}

}  // namespace
}  // namespace scarp
