// SPDX-License-Identifier: BSD-3-Clause
/// Scenes turned against the lattice.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/small_scenes.hpp"
#include "validation/cases/askew/turned.hpp"

namespace scarp::validation {
namespace {

Scene block() {
  Scene scene = test::elastic_column("modern", 2.0, 0.1);
  scene.numerics.force_correction = false;  // geostatic stress starts as it is
  scene.bodies = {{.shape = Polygon{{{0, 0}, {1, 0}, {1, 2}, {0, 2}}}}};
  scene.initial_stress = InitialStress::geostatic;
  return scene;
}

TEST(TurnedTest, StressAtTheStartIsThatOfTheWeightInItsOwnAxes) {
  for (const double angle : {0.3, -0.7, 2.0}) {
    const Scene scene = turned(block(), angle);
    const double weight = scene.materials.front().density * 9.81;
    for (const TurnedBack& one : turned_back(Simulation(scene, {1, {}}), angle)) {
      EXPECT_GT(one.start[0], 0.0);
      EXPECT_LT(one.start[0], 1.0);
      // Ends of rays are found to dx/512.
      const double exact = -weight * (2.0 - one.start[1]), tolerance = weight * 0.1 / 512.0;
      EXPECT_NEAR(one.yy, exact, tolerance);
      EXPECT_NEAR(one.xx, exact * 0.3 / 0.7, tolerance);
      EXPECT_NEAR(one.xy, 0.0, tolerance);
    }
  }
}

TEST(TurnedTest, NothingIsTurnedByZero) {
  const Scene scene = turned(block(), 0.0);
  EXPECT_EQ(scene.walls.front().facets.front().normal, block().walls.front().facets.front().normal);
  EXPECT_EQ(scene.gravity, block().gravity);
}

TEST(TurnedTest, OnlyPolygonsAreTurned) {
  EXPECT_THROW(turned(test::elastic_column("modern", 2.0, 0.1), 0.3), std::exception);
}

}  // namespace
}  // namespace scarp::validation
