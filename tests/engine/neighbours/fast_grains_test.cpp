// SPDX-License-Identifier: BSD-3-Clause
/// Lists that reach further around fast grains serve longer and leave no pair out.
#include "engine/neighbours/fast_grains.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// Against lists that reach a whole smoothing length further around everybody. The grain flies into
/// the bed's reach, meets the smooth wall and its own image there, and bounces from the bed.
TEST(FastGrainsTest, EveryPairIsListed) {
  for (const char* name : {"paper", "modern"}) {
    Scene scene = bed_and_grain(name);
    scene.numerics.viscosity_beta = 2.0;
    Scene wide = scene;
    wide.numerics.skin = 2.0;
    Simulation one(scene, {1, {}}), other(wide, {1, {}});
    const std::vector<double> start = one.field("velocity");
    const auto grain = static_cast<std::size_t>(one.soil_count() - 1);
    for (int k = 0; k < (std::string(name) == "paper" ? 400 : 120); ++k) {
      one.step();
      other.step();
    }
    const std::vector<double> a = one.field("velocity"), b = other.field("velocity");
    EXPECT_GT(a[3 * grain + 1], start[3 * grain + 1] + 4.0) << "it has hit nothing";
    // Sums of 20 neighbours in another order, that differ by eps of their size, stress over rho dx,
    // in each of some hundred steps; contacts amplify it, by less than a million.
    for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 1e-8) << name << ' ' << k;
  }
}

TEST(FastGrainsTest, AloneNeedListsOfTheirOwn) {
  const Scene scene = bed_and_grain("modern");
  Scene slow = scene;
  slow.bodies[1].velocity = {};
  Scene many = scene;
  many.bodies[0].velocity = {3.0, 0.0, 0.0};  // the bed slides as fast as its lists bear
  many.walls.clear();
  const auto rebuilds = [](const Scene& of) { return run_steps(of, 60).rebuild_count(); };
  // At 13 m/s and steps of h/c, c = 37 m/s, half a skin lasts a third of a step.
  EXPECT_LE(rebuilds(scene), 12u);
  EXPECT_LE(rebuilds(slow), 6u);
  EXPECT_GT(rebuilds(many), 20u);
}

}  // namespace
}  // namespace scarp::test
