// SPDX-License-Identifier: BSD-3-Clause
/// One material point, step by step, against closed forms.
#include "engine/element/material_point.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr double E = 100e6, nu = 0.3;
constexpr double bulk = E / (3 * (1 - 2 * nu)), shear = E / (2 * (1 + nu));

Scene scene_of(const Material& material, const char* preset_name = "modern") {
  Scene scene = elastic_column(preset_name, 1.0, 0.25);
  scene.materials = {material};
  return scene;
}
Material elastic_rock() { return elastic(E); }
/// Shear strength of 10 kPa and no friction.
Material stiff_clay() {
  return {"clay", DruckerPrager{E, nu, 10e3, 0.0, 0.0, Cone::plane_strain}, 2000.0};
}

GradientIncrement stretch(double x, double y, double z) { return {x, 0, 0, 0, y, 0, 0, 0, z}; }

TEST(MaterialPointTest, ElasticStressIsHookesLaw) {
  for (const char* name : {"modern", "paper"}) {
    const MaterialPoint point(scene_of(elastic_rock(), name), {}, 3);
    const std::array<double, 6> start{-1e5, -2e5, -3e5, 1e4, 2e4, -3e4};
    const PointState rest = point.at(start);
    EXPECT_EQ(rest.stress, start);
    EXPECT_EQ(rest.density, 2000.0);
    // Symmetric increments: no spin. Engineering shear is twice the tensor component.
    const GradientIncrement increment{1e-4, 3e-5, -2e-5, 3e-5, -2e-4, 4e-5, -2e-5, 4e-5, 5e-5};
    const PointState end = point.advance(rest, increment);
    const std::array<double, 6> strain{1e-4, -2e-4, 5e-5, 3e-5, 4e-5, -2e-5};
    const double trace = strain[0] + strain[1] + strain[2];
    for (std::size_t c = 0; c < 6; ++c) {
      EXPECT_NEAR(end.strain[c], strain[c], 1e-19);
      const double pressure = c < 3 ? (bulk - 2.0 / 3.0 * shear) * trace : 0.0;
      EXPECT_NEAR(end.stress[c], start[c] + 2 * shear * strain[c] + pressure, 1e-10 * 3e5);
    }
    EXPECT_EQ(end.history[0], 0.0);
    EXPECT_NEAR(point.first_invariant(rest), -6e5, 1e-9);
    // s = (1, 0, -1) 1e5 off the mean, and the shears: J2 = (1 + 1)/2 1e10 + (1 + 4 + 9) 1e8
    EXPECT_NEAR(point.root_j2(rest), std::sqrt(1e10 + 14e8), 1e-9);
  }
}

TEST(MaterialPointTest, PlaneStrainIsThePassOfThreeDimensionsWithoutItsThird) {
  for (const Material& material : {elastic_rock(), stiff_clay(), clay()}) {
    const Scene scene = scene_of(material);
    const MaterialPoint plane(scene, {}, 2), space(scene, {}, 3);
    PointState a = plane.at({-5e4, -8e4, -6e4, 0, 0, 0}), b = a;
    for (int k = 0; k < 50; ++k) {
      const double turn = 2e-5 * k;
      const GradientIncrement increment{4e-5, 6e-5 + turn, 0, -turn, -7e-5, 0, 0, 0, 0};
      a = plane.advance(a, increment);
      b = space.advance(b, increment);
    }
    for (std::size_t c = 0; c < 6; ++c) EXPECT_NEAR(a.stress[c], b.stress[c], 1e-9 * 1e5);
    EXPECT_NEAR(a.history[0], b.history[0], 1e-14);
  }
}

/// Hughes and Winget turn by 2 atan(w/2) a step, w the spin times the step: a quarter turn in N
/// steps of w = 2 tan(pi/(4 N)) exchanges the axes exactly, whatever N.
TEST(MaterialPointTest, AQuarterTurnExchangesTheAxes) {
  for (const int steps : {1, 2, 7, 100}) {
    const MaterialPoint point(scene_of(elastic_rock()), {}, 3);
    PointState state = point.at({-1e5, -4e5, -2e5, 3e4, 1e4, -2e4});
    const double w = 2 * std::tan(std::numbers::pi / 4 / steps);
    for (int k = 0; k < steps; ++k)  // dv_y/dx = w: x towards y
      state = point.advance(state, {0, -w, 0, w, 0, 0, 0, 0, 0});
    const std::array<double, 6> turned{-4e5, -1e5, -2e5, -3e4, -2e4, -1e4};
    for (std::size_t c = 0; c < 6; ++c)
      EXPECT_NEAR(state.stress[c], turned[c], 1e-14 * 4e5 * (steps + 10));
    EXPECT_EQ(state.density, 2000.0);
  }
}

/// Shear without friction stops at the cohesion; back from there the soil is elastic until it
/// yields on the other side, after a strain of twice c/(2G).
TEST(MaterialPointTest, ShearYieldsAtTheCohesionAndUnloadsElastically) {
  const MaterialPoint point(scene_of(stiff_clay()), {}, 2);
  PointState state = point.at({-1e5, -1e5, -1e5, 0, 0, 0});
  const double step = 1e-6, elastic_limit = 10e3 / (2 * shear);  // tensor strain
  const auto sheared = [&](const PointState& from, double by) {
    return point.advance(from, {0, by, 0, by, 0, 0, 0, 0, 0});
  };
  int k = 0;
  for (; (k + 1) * step < elastic_limit; ++k) {
    state = sheared(state, step);
    EXPECT_NEAR(state.stress[3], 2 * shear * step * (k + 1), 1e-8);
    EXPECT_EQ(state.history[0], 0.0);
  }
  for (int more = 0; more < 100; ++more) state = sheared(state, step);
  EXPECT_NEAR(state.stress[3], 10e3, 1e-8);
  EXPECT_NEAR(point.yield_function(state), 0.0, 1e-8);
  EXPECT_NEAR(point.first_invariant(state), -3e5, 1e-7);
  // d eps_p = sqrt(2/3 de : de), of the tensor shear e twice: 2/sqrt(3) e.
  EXPECT_NEAR(state.history[0], 2 / std::sqrt(3.0) * ((k + 100) * step - elastic_limit), 1e-14);
  const double plastic = state.history[0];
  state = sheared(state, -1.9 * elastic_limit);
  EXPECT_NEAR(state.stress[3], 10e3 - 1.9 * 10e3, 1e-8);
  EXPECT_EQ(state.history[0], plastic);
  EXPECT_NEAR(sheared(state, -elastic_limit).stress[3], -10e3, 1e-8);
}

TEST(MaterialPointTest, ReducedStrengthYieldsEarlier) {
  for (const double reduction : {0.5, 1.0, 1.6}) {
    const MaterialPoint point(scene_of(stiff_clay()), {}, 2, {}, reduction);
    PointState state = point.at({});
    for (int k = 0; k < 30; ++k) state = point.advance(state, {0, 1e-5, 0, 1e-5, 0, 0, 0, 0, 0});
    EXPECT_NEAR(state.stress[3], 10e3 / reduction, 1e-8);
  }
}

/// `modern` takes the density rate -rho tr L and holds it within bounds; the rate acts over one
/// step on the density before.
TEST(MaterialPointTest, DensityFollowsTheVolumeWithinItsBounds) {
  const Scene scene = scene_of(elastic_rock());
  const MaterialPoint point(scene, {}, 3);
  PointState state = point.at({});
  for (const double by : {1e-3, -2e-3, 5e-4}) {
    const double before = state.density;
    state = point.advance(state, stretch(by, 2 * by, -0.5 * by));
    EXPECT_NEAR(state.density, before * (1 - 2.5 * by), 1e-12 * 2000);
  }
  EXPECT_EQ(point.advance(state, stretch(-0.2, -0.2, -0.2)).density,
            scene.numerics.density_maximum * 2000);
  EXPECT_EQ(point.advance(state, stretch(0.3, 0.3, 0.3)).density,
            scene.numerics.density_minimum * 2000);
}

}  // namespace
}  // namespace scarp::test
