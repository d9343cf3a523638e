// SPDX-License-Identifier: BSD-3-Clause
/// Soil beside much stiffer ground: what is known of the stress on both sides of the interface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr double soft = 10e6, weight = 2000.0 * 9.81;

Material rock(double youngs_modulus, double poisson_ratio) {
  return {"rock", LinearElastic{youngs_modulus, poisson_ratio}, 2000.0};
}
/// Yields, in name: it takes part in the stress diffusion.
Material soil(double cohesion, double friction_angle) {
  return {"soil", DruckerPrager{soft, 0.3, cohesion, friction_angle, 0.0, Cone::plane_strain},
          2000.0};
}

Simulation settled(Scene scene) {
  Simulation simulation(std::move(scene), {1, {}});
  while (!simulation.finished()) simulation.step();
  EXPECT_TRUE(simulation.stage_reached_rest());
  return simulation;
}

/// Level layers between smooth sides, loaded by their weight at once: it squeezes them in one
/// direction alone, so that the stress across is nu/(1 - nu) of that along gravity, at all times
/// and in every row. Of the rock, with nu = 0, it is zero: the stress jumps where they meet.
TEST(StiffnessContrastTest, TheStressAlongALevelInterfaceIsThatOfEachSide) {
  constexpr double height = 2.0, dx = 0.25;
  for (const Integrator integrator : {Integrator::kick_drift_kick, Integrator::verlet}) {
    for (const bool rock_below : {true, false}) {
      Scene scene = elastic_column("modern", height, dx);
      scene.numerics.integrator = integrator;
      if (integrator == Integrator::verlet) scene.numerics.cfl = 0.3;
      scene.materials = {soil(1e6, 0.35), rock(1e4 * soft, 0.0)};
      const double interface = rock_below ? 0.75 : 1.25;
      const Box below{{0, 0, 0}, {1, interface, 0}}, above{{0, interface, 0}, {1, height, 0}};
      scene.bodies = {{.shape = rock_below ? below : above, .material = "rock"},
                      {.shape = rock_below ? above : below, .material = "soil"}};
      scene.stages[0].damping = 60.0;  // near critical for the soil
      scene.stages[0].rest_velocity = 1e-4;
      const Simulation simulation = settled(scene);
      const auto stress = simulation.field("stress"), material = simulation.field("material"),
                 position = simulation.field("position");
      for (std::size_t k = 0; k < material.size(); ++k) {
        const double along = stress[6 * k + 1], across = stress[6 * k],
                     ratio = material[k] == 0.0 ? 0.3 / 0.7 : 0.0;
        const double depth = height - position[3 * k + 1];
        // Zigzags from row to row: the lattice leaves half a row's weight open.
        EXPECT_NEAR(along, -weight * depth, 0.5 * weight * dx) << depth;
        // Round-off of 1e5 steps; for the rock it is that of its stiffness, 1e4 times as much.
        EXPECT_NEAR(across, ratio * along, 1e-7 * weight * height) << depth;
      }
    }
  }
}

/// The slope of validation/contrast: it has a factor of safety of 1.31.
Scene slope_on_rock(double contrast) {
  Scene scene = small_slope("modern", 10.0, 1e-3, 1.0);
  scene.materials = {rock(contrast * soft, 0.3), soil(10e3, 20.0 * std::numbers::pi / 180.0)};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {45, 3, 0}}, .material = "rock"},
                  {.shape = Polygon{{{0, 3}, {45, 3}, {45, 5}, {32, 5}, {12, 15}, {0, 15}}},
                   .material = "soil"}};
  scene.stages.resize(1);
  scene.stages[0].until = StageEnd::rest;
  scene.stages[0].reset_after = false;
  scene.stages[0].damping = 8.5;  // pi c/(2 H) of the soil
  return scene;
}

/// Of a component of stress of the soil.
double largest_difference(const Simulation& one, const Simulation& other) {
  const auto a = one.field("stress"), b = other.field("stress"), material = one.field("material");
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (material[k / 6] == 1.0) most = std::max(most, std::abs(b[k] - a[k]));
  }
  return most;
}

TEST(StiffnessContrastTest, ASlopeStandsOnRockAsStiffAsItMayBe) {
  const Simulation at_thousand = settled(slope_on_rock(1e3)),
                   at_ten_thousand = settled(slope_on_rock(1e4));
  // Under the same stress the stiffer rock strains 1e-3 of the soil less. The stress of the soil is
  // known to half a row: a particle stands for all of its own.
  EXPECT_LT(largest_difference(at_thousand, at_ten_thousand), 0.5 * weight * 1.0);
  // No slide beyond the settlement of the softer soil, weight H^2/(2 M), H = 12 m on the rock.
  const double modulus = soft * 0.7 / (1.3 * 0.4), settlement = weight * 144.0 / (2.0 * modulus);
  for (const double way : at_ten_thousand.field("displacement"))
    EXPECT_LT(std::abs(way), settlement);
}

/// Nothing happens at the contrast of one: elastic ground is no soil there either.
TEST(StiffnessContrastTest, AThousandthOfStiffnessIsAThousandthOfStress) {
  const Simulation equal = settled(slope_on_rock(1.0)), stiffer = settled(slope_on_rock(1.001));
  EXPECT_LT(largest_difference(equal, stiffer), 1e-3 * weight * 12.0);
}

}  // namespace
}  // namespace scarp::test
