// SPDX-License-Identifier: BSD-3-Clause
/// Geostatic scenes stay where they are, and layers keep the K0 they were given.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/check/initial_stress.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr double g = 9.81;

Body box(const std::string& material, const Vec3& minimum, const Vec3& maximum) {
  return {.shape = Box{minimum, maximum}, .material = material};
}

/// Smooth sides from (0, 0) to (width, height) on a base.
std::vector<Wall> bin(double width, double height, WallKind base) {
  return {wall_of("base", base, {facet_2d(0, 0, width, 0)}),
          wall_of("sides", WallKind::free_slip,
                  {facet_2d(width, 0, width, height), facet_2d(0, height, 0, 0)})};
}

double stiffness(const Material& m) {
  const double nu = m.model.parameter("poisson_ratio");
  return m.model.parameter("youngs_modulus") * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu));
}

/// Peat over rock: the stress at the start, and that the column then stays.
TEST(GeostaticTest, LightSoilOverHeavyRockStaysAtRest) {
  Scene scene;
  scene.spacing = 0.5;
  scene.materials = {{"peat", LinearElastic{20e6, 0.3}, 1000.0},
                     {"rock", LinearElastic{20e6, 0.3}, 2600.0}};
  scene.bodies = {box("peat", {0, 5, 0}, {4, 10, 0}), box("rock", {0, 0, 0}, {4, 5, 0})};
  scene.walls = bin(4, 14, WallKind::no_slip);
  scene.initial_stress = InitialStress::geostatic;
  scene.stages = {stage_for("wait", 0.5)};  // 8 passages of a wave
  Simulation simulation(scene, {1, {}});
  const std::vector<double> position = simulation.field("position");
  const std::vector<double> stress = simulation.field("stress");
  for (std::size_t i = 0; 3 * i < position.size(); ++i) {
    const double y = position[3 * i + 1];
    const double weight =
        g * (1000.0 * (10.0 - std::max(y, 5.0)) + 2600.0 * (5.0 - std::min(y, 5.0)));
    EXPECT_NEAR(stress[6 * i + 1], -weight, 1e-9 * weight);
    EXPECT_NEAR(stress[6 * i], -0.3 / 0.7 * weight, 1e-9 * weight);
    if (std::abs(y - 4.75) < 0.01) {
      EXPECT_NEAR(weight, 55.4e3, 50.0);
    }
    if (std::abs(y - 0.25) < 0.01) {
      EXPECT_NEAR(weight, 170.2e3, 50.0);
    }
  }
  while (!simulation.finished()) simulation.step();
  // What the lattice leaves out of balance is at most half a row's weight, at the top and where the
  // densities meet: twice its settlement, as it comes at once.
  const double most =
      2.0 * g * 0.5 * 0.5 * (1000.0 + 1600.0) * 10.0 / stiffness(scene.materials[0]);
  const std::vector<double> displacement = simulation.field("displacement");
  for (const double u : displacement) EXPECT_LT(std::abs(u), most);
}

TEST(GeostaticTest, AHangingBoulderDoesNotThrowTheBedUp) {
  Scene scene;
  scene.spacing = 0.2;
  scene.materials = {
      {"soil", DruckerPrager{20e6, 0.3, 5e3, 0.5236, 0.0, Cone::plane_strain}, 2000.0},
      {"boulder", LinearElastic{20e6, 0.3}, 2600.0}};
  scene.bodies = {box("soil", {0, 0, 0}, {6, 1, 0}), box("boulder", {2.4, 11, 0}, {3.6, 12, 0})};
  scene.walls = bin(6, 14, WallKind::no_slip);
  scene.initial_stress = InitialStress::geostatic;
  scene.stages = {stage_for("fall", 0.1)};
  Simulation simulation(scene, {1, {}});
  const std::vector<double> position = simulation.field("position");
  const std::vector<double> stress = simulation.field("stress");
  for (std::size_t i = 0; 3 * i < position.size(); ++i) {
    if (std::abs(position[3 * i + 1] - 0.9) < 0.01) {
      EXPECT_NEAR(stress[6 * i + 1], -2000.0 * g * 0.1, 1e-6);
    }
  }
  double fastest = 0.0;
  while (!simulation.finished()) {
    simulation.step();
    const std::vector<double> velocity = simulation.field("velocity");
    const std::vector<double> material = simulation.field("material");
    for (std::size_t i = 0; i < material.size(); ++i) {
      if (material[i] == 0.0) fastest = std::max(fastest, std::abs(velocity[3 * i + 1]));
    }
  }
  // Half a row's weight out of balance at the top starts a wave of s/(rho c), doubled there.
  const double c = std::sqrt(stiffness(scene.materials[0]) / 2000.0);
  EXPECT_LT(fastest, 2.0 * g * 0.5 * scene.spacing / c);
}

/// What lies 100 m higher on a shelf is no part of the bed: it takes no part in how the bed is
/// damped and how long it must be calm.
TEST(GeostaticTest, ABlockOnAShelfAboveDoesNotSlowTheSettlingDown) {
  Scene scene;
  scene.spacing = 0.25;
  scene.materials = {{"soil", LinearElastic{20e6, 0.3}, 2000.0}};
  scene.bodies = {box("soil", {0, 0, 0}, {2, 1, 0}), box("soil", {0, 100, 0}, {2, 101, 0})};
  scene.walls = bin(2, 2, WallKind::no_slip);
  scene.walls.push_back(wall_of("shelf", WallKind::no_slip, {facet_2d(0, 100, 2, 100)}));
  scene.walls.push_back(wall_of("shelf sides", WallKind::free_slip,
                                {facet_2d(2, 100, 2, 102), facet_2d(0, 102, 0, 100)}));
  scene.initial_stress = InitialStress::geostatic;
  scene.stages = {stage_for("settle", 30.0), stage_for("after", 0.001)};
  scene.stages[0].until = StageEnd::rest;
  scene.stages[0].reset_after = true;
  Simulation simulation(scene, {1, {}});
  while (!simulation.stage_ended()) simulation.step();
  EXPECT_TRUE(simulation.stage_reached_rest());
  // With the whole extent of 101 m calm alone would have to last four passages over it.
  const double c = std::sqrt(stiffness(scene.materials[0]) / 2000.0);
  EXPECT_GE(simulation.last_step().stage_time, 4.0 * 1.0 / c);
  EXPECT_LT(simulation.last_step().stage_time, 4.0 * 101.0 / c);
}

/// Sums of stress over the particles of a layer, as a ratio: horizontal over vertical.
double mean_k0(const Simulation& simulation, double material) {
  const std::vector<double> of = simulation.field("material");
  const std::vector<double> stress = simulation.field("stress");
  double across = 0.0, along = 0.0;
  for (std::size_t i = 0; i < of.size(); ++i) {
    if (of[i] != material) continue;
    across += stress[6 * i];
    along += stress[6 * i + 1];
  }
  return across / along;
}

Stage until_rest() {
  Stage settle = stage_for("settle", 30.0);
  settle.until = StageEnd::rest;
  settle.reset_after = true;
  return settle;
}

TEST(GeostaticTest, ASettledStackOfLayersKeepsTheK0OfEach) {
  for (const WallKind base : {WallKind::no_slip, WallKind::free_slip}) {
    Scene scene;
    scene.spacing = 0.125;
    // Densities, stiffness and K0 all change from layer to layer; the strength holds them.
    scene.materials = {
        {"peat", DruckerPrager{5e6, 0.3, 50e3, 0.6, 0.0, Cone::plane_strain}, 1000.0, 0.6},
        {"clay", DruckerPrager{20e6, 0.4, 50e3, 0.6, 0.0, Cone::plane_strain}, 2000.0, 1.0},
        {"rock", LinearElastic{100e6, 0.25}, 2600.0}};
    scene.bodies = {box("peat", {0, 2, 0}, {1, 3, 0}), box("clay", {0, 1, 0}, {1, 2, 0}),
                    box("rock", {0, 0, 0}, {1, 1, 0})};
    scene.walls = bin(1, 4, base);
    scene.initial_stress = InitialStress::geostatic;
    scene.initial_k0 = 0.45;  // of the rock, which has none of its own
    scene.stages = {until_rest(), stage_for("after", 0.001)};
    Simulation simulation(scene, {1, {}});
    while (simulation.stage_index() == 0) simulation.step();
    const double expected[] = {0.6, 1.0, 0.45};
    for (std::size_t m = 0; m < 3; ++m) {
      EXPECT_NEAR(mean_k0(simulation, static_cast<double>(m)), expected[m], 0.02 * expected[m])
          << scene.materials[m].name;
    }
  }
}

/// Sand at phi = 30 deg with nu = 0.3 between smooth sides; a negative k0: that of nu.
Scene sand_bin(double cohesion, double k0) {
  Scene scene;
  scene.spacing = 0.125;
  scene.materials = {
      {"sand", DruckerPrager{20e6, 0.3, cohesion, 0.5236, 0, Cone::plane_strain}, 1800.0}};
  if (k0 >= 0.0) scene.materials[0].k0 = k0;
  scene.bodies = {box("sand", {0, 0, 0}, {1, 2, 0})};
  scene.walls = bin(1, 3, WallKind::free_slip);
  scene.initial_stress = InitialStress::geostatic;
  scene.stages = {until_rest(), stage_for("after", 0.001)};
  return scene;
}

/// The stress diffusion takes the weight of the soil out of what it evens out: where soil is
/// sheared under its weight, a free surface included, it changes nothing.
TEST(GeostaticTest, StressDiffusionLeavesTheWeight) {
  const auto stress_after_shear = [](double diffusion) {
    Scene scene = elastic_column("modern", 1.0, 0.1);
    scene.materials = {clay()};
    scene.materials[0].model.set("cohesion", 1e6);  // does not yield
    scene.numerics.stress_diffusion = diffusion;
    scene.numerics.diffusion_shear_gate = 1e6;  // so that a gentle shear opens it
    scene.bodies = {{.shape = Box{{0, 0, 0}, {6, 1, 0}}, .velocity_field = {"1e-3 * y", "0"}}};
    scene.walls = {wall_of("base", WallKind::free_slip, {facet_2d(-5, 0, 11, 0)})};
    scene.initial_stress = InitialStress::geostatic;
    scene.stages = {stage_for("shear", 1.0)};
    const Simulation simulation = run_steps(scene, 10, {1, {}});
    std::vector<double> middle;  // which no wave from the ends has reached
    const std::vector<double> place = simulation.field("position"),
                              stress = simulation.field("stress");
    for (std::size_t k = 0; 3 * k < place.size(); ++k) {
      if (std::abs(place[3 * k] - 3.0) > 0.5) continue;
      middle.insert(middle.end(), {stress[6 * k], stress[6 * k + 1], stress[6 * k + 2]});
    }
    return middle;
  };
  const std::vector<double> with = stress_after_shear(1.0), without = stress_after_shear(0.0);
  ASSERT_EQ(with.size(), 3u * 100u);
  // The lattice leaves up to half a row's weight out of balance at the surface; diffusion acts on
  // what comes of that.
  for (std::size_t k = 0; k < with.size(); ++k)
    EXPECT_NEAR(with[k], without[k], 0.5 * 2000.0 * g * 0.1) << k;
}

TEST(InitialStressTest, AK0OutsideTheConeIsToldWithWhatItBecomes) {
  // 0.429 by nu/(1 - nu), below the active end; 6 is above the passive one.
  for (const double k0 : {-1.0, 6.0}) {
    Simulation simulation(sand_bin(0.0, k0), {1, {}});
    const RestRange range = rest_range(simulation.scene().materials[0], 1.0, 1e3);
    const double becomes = k0 < 0.0 ? range.active : range.passive;
    EXPECT_NEAR(becomes, k0 < 0.0 ? 0.4648 : 2.869, 1e-3);  // (1 -+ s)/(1 +- 2 s), s = 0.27735
    const std::vector<std::string> found = initial_stress_warnings(simulation);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NE(found[0].find(k0 < 0.0 ? "K0 becomes 0.465" : "K0 becomes 2.87"), std::string::npos)
        << found[0];
    EXPECT_EQ(found[0].find("nu/(1 - nu)") != std::string::npos, k0 < 0.0);
    while (simulation.stage_index() == 0) simulation.step();
    EXPECT_NEAR(mean_k0(simulation, 0.0), becomes, 0.02 * becomes);
  }
}

TEST(InitialStressTest, CohesionAndAStrongerFirstStageWidenTheRange) {
  // At the deepest, under 34.2 kPa, 0.429 needs t >= 0.0563: c >= 1.34 kPa.
  EXPECT_EQ(initial_stress_warnings(Simulation(sand_bin(1.3e3, -1.0), {1, {}})).size(), 1u);
  EXPECT_TRUE(initial_stress_warnings(Simulation(sand_bin(1.4e3, -1.0), {1, {}})).empty());
  Scene strong = sand_bin(0.0, -1.0);
  strong.stages[0].strength_reduction = 0.5;
  EXPECT_TRUE(initial_stress_warnings(Simulation(strong, {1, {}})).empty());
  EXPECT_TRUE(initial_stress_warnings(Simulation(sand_bin(0.0, 0.5), {1, {}})).empty());
}

TEST(InitialStressTest, AUniformStressOutsideTheConeIsToldWithItsShare) {
  Scene scene = sand_bin(0.0, -1.0);
  scene.initial_stress = InitialStress::uniform;
  // K = 0.4: sqrt(J2)/(-a I1) = 0.6/(sqrt(3) 1.8 a) = 1.2018 with a = 0.16013; at 0.5 it is 0.901.
  scene.uniform_stress = {-40e3, -100e3, -40e3, 0, 0, 0};
  const std::vector<std::string> found = initial_stress_warnings(Simulation(scene, {1, {}}));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NE(found[0].find("1.2 times what the surface bears"), std::string::npos) << found[0];
  scene.uniform_stress = {-50e3, -100e3, -50e3, 0, 0, 0};
  EXPECT_TRUE(initial_stress_warnings(Simulation(scene, {1, {}})).empty());
  scene.uniform_stress = {10e3, 10e3, 10e3, 0, 0, 0};  // nothing holds sand in tension
  EXPECT_EQ(initial_stress_warnings(Simulation(scene, {1, {}})).size(), 1u);
}

TEST(InitialStressTest, ObliqueGravityTurnsTheStressWithIt) {
  Scene scene = sand_bin(0.0, 0.5);
  scene.gravity = {g * 0.6, -g * 0.8, 0.0};
  const Simulation simulation(scene, {1, {}});
  const std::vector<double> stress = simulation.field("stress");
  const std::vector<double> position = simulation.field("position");
  for (std::size_t i = 0; 3 * i < position.size(); ++i) {
    const double x = position[3 * i], y = position[3 * i + 1];
    const double p = 1800.0 * g * std::min((2.0 - y) / 0.8, x / 0.6);
    const double close = 1800.0 * g * scene.spacing / 512.0;
    EXPECT_NEAR(stress[6 * i], -p * (0.5 + 0.5 * 0.36), close);
    EXPECT_NEAR(stress[6 * i + 1], -p * (0.5 + 0.5 * 0.64), close);
    EXPECT_NEAR(stress[6 * i + 2], -p * 0.5, close);
    EXPECT_NEAR(stress[6 * i + 3], p * 0.5 * 0.48, close);  // up is (-0.6, 0.8)
  }
}

}  // namespace
}  // namespace scarp::test
