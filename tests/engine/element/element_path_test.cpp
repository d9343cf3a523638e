// SPDX-License-Identifier: BSD-3-Clause
/// Element tests against closed forms of Drucker-Prager soil; 1e-3 unless said otherwise.
#include "engine/element/element_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/element/material_point.hpp"
#include "engine/errors.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr double B = 100e3, root3 = std::numbers::sqrt3, degree = std::numbers::pi / 180.0;

Scene scene_of(const Material& material, const std::string& preset_name = "modern",
               int dimension = 2) {
  Scene scene = elastic_column(preset_name, 1.0, 0.25);
  scene.materials = {material};
  if (dimension == 3) {
    scene.dimension = 3;
    scene.bodies = {{.shape = Box{{0, 0, 0}, {1, 1, 1}}}};
    scene.walls.clear();
  }
  return scene;
}

/// Every cone with psi 0, between and phi; phi = 0; c = 0.
std::vector<Material> soils() {
  std::vector<Material> all;
  for (const double cone : {0.0, 1.0, 2.0}) {
    const auto add = [&](double c, double phi, double psi) {
      all.push_back({"soil",
                     DruckerPrager{100e6, 0.3, c, phi * degree, psi * degree,
                                   static_cast<Cone>(static_cast<int>(cone))},
                     2000.0});
    };
    add(10e3, 0.0, 0.0);
    for (const double c : {0.0, 10e3}) {
      for (const double psi : {0.0, 12.0, 30.0}) add(c, 30.0, psi);
    }
  }
  return all;
}

ElementResult driven(const Scene& scene, ElementPath path, double strain, int steps = 1000) {
  return run_element(scene, {path, {}, B, strain, steps});
}

template <class Check>
void for_all_soils(Check&& check) {
  for (const std::string preset_name : {"modern", "paper"}) {
    for (const Material& soil : soils()) {
      for (const int dimension : {2, 3}) check(scene_of(soil, preset_name, dimension));
    }
  }
}

TEST(ElementPathTest, TriaxialFailureInCompressionAndExtension) {
  for_all_soils([](const Scene& scene) {
    const auto pressed = driven(scene, ElementPath::triaxial, 0.05);
    const double a = pressed.constants.at("alpha_phi"), k = pressed.constants.at("k_c"),
                 b = pressed.constants.at("alpha_psi");
    const ElementSample& end = pressed.samples.back();
    const double highest = (B / root3 + k + 2 * a * B) / (1 / root3 - a);
    EXPECT_NEAR(-end.stress[1], highest, 1e-3 * highest);
    // The direction of flow never turns: the return is exact, and what is left is the tolerance of
    // the control, 1e-9 of the stress, over the elastic stiffness; 1e-6 of the strain holds it.
    EXPECT_NEAR(end.plastic_volumetric_strain, 3 * root3 * b * end.history[0],
                1e-6 * end.history[0]);
    EXPECT_LE(std::fabs(end.yield_function), 1e-9 * highest);
    EXPECT_LE(pressed.control_error, 1e-3);
    const ElementSample& first = pressed.samples[1];
    EXPECT_NEAR((first.stress[1] + B) / first.strain[1], 100e6, 1e-3 * 100e6);
    EXPECT_NEAR(-first.strain[0] / first.strain[1], 0.3, 3e-4);
    const auto pulled = driven(scene, ElementPath::triaxial, -0.05);
    const double lowest = (B / root3 - k - 2 * a * B) / (1 / root3 + a);
    EXPECT_NEAR(-pulled.samples.back().stress[1], lowest, 1e-3 * B);
  });
}

TEST(ElementPathTest, PlaneStrainFailure) {
  for_all_soils([](const Scene& scene) {
    const auto result = driven(scene, ElementPath::plane_strain, 0.2, 2000);
    const double a = result.constants.at("alpha_phi"), k = result.constants.at("k_c"),
                 b = result.constants.at("alpha_psi");
    const double w = std::sqrt(1 - 3 * b * b), j = (k + 3 * a * B) / (1 - 3 * a * (w + b));
    const ElementSample& end = result.samples.back();
    EXPECT_NEAR(-end.stress[1], B + 2 * w * j, 1e-3 * (B + 2 * w * j));
    // s_zz = -2 J b, I1/3 = -B - J b - w J
    EXPECT_NEAR(-end.stress[2], B + 3 * b * j + w * j, 1e-3 * (B + 2 * w * j));
  });
}

/// Steady simple shear under constant sigma_yy. No stress rate is left, so with flow rate L, e =
/// J/G, t = tau/J: the stress rate of the spin, (1, -1, 0) tau, is balanced by the elastic one,
/// whose strain rate has no trace, which gives s_xx/J = -2b + e t/L, s_yy/J = 4b - e t/L, s_zz/J =
/// -2b and L t = 1 + 3 b e - e^2 t/L. As e -> 0: tau = J sqrt(1 - 12 b^2), J = (k + 3aB)/(1 -
/// 12ab).
double steady_shear_stress(double a, double k, double b, double shear_modulus) {
  double j = k + 3 * a * B, t = 1.0, turn = 0.0;  // turn = e t/L
  for (int n = 0; n < 200; ++n) {
    const double e = j / shear_modulus, x = -2 * b + turn, y = 4 * b - turn;
    t = std::sqrt(1 - 0.5 * (x * x + y * y + 4 * b * b));
    const double rate = (1 + 3 * b * e - e * turn) / t;
    turn = e * t / rate;
    j = k + 3 * a * (B + j * (4 * b - turn));
  }
  return j * t;
}

TEST(ElementPathTest, SteadySimpleShear) {
  for_all_soils([](const Scene& scene) {
    const auto result = driven(scene, ElementPath::simple_shear, 0.3, 6000);
    const double tau =
        steady_shear_stress(result.constants.at("alpha_phi"), result.constants.at("k_c"),
                            result.constants.at("alpha_psi"), result.shear_modulus);
    EXPECT_NEAR(result.samples.back().stress[3], tau, 1e-3 * tau);
    EXPECT_NEAR(result.samples.back().stress[1], -B, 1e-6 * B);
  });
}

TEST(ElementPathTest, IsotropicIsElasticUpToTheApex) {
  for_all_soils([](const Scene& scene) {
    const auto pressed = driven(scene, ElementPath::isotropic, 0.01);
    // 1000 sums of increments: 1000 eps of the stress.
    const double expected = -3 * (B + pressed.bulk_modulus * 0.01);
    EXPECT_NEAR(pressed.samples.back().first_invariant, expected, 1e-12 * -expected);
    EXPECT_EQ(pressed.first_yield, 0U);
    const auto pulled = driven(scene, ElementPath::isotropic, -0.01);
    const double free = -3 * (B - pulled.bulk_modulus * 0.01);
    const double apex = pulled.constants.at("alpha_phi") > 0
                            ? pulled.constants.at("k_c") / pulled.constants.at("alpha_phi")
                            : free;
    EXPECT_NEAR(pulled.samples.back().first_invariant, apex, 1e-12 * free);
  });
}

/// Jaumann elasticity under constant sigma_yy: tau = G/q sin(q gamma), q^2 = (1 + lambda/M)/2.
TEST(ElementPathTest, ElasticSimpleShearConvergesToItsClosedForm) {
  for (const std::string preset_name : {"modern", "paper"}) {
    const Scene scene = scene_of(elastic(), preset_name);
    double last = 0.0;
    for (const int steps : {100, 200, 400}) {
      const auto result = driven(scene, ElementPath::simple_shear, 1.0, steps);
      EXPECT_TRUE(std::isnan(result.samples.back().yield_function));
      const double g = result.shear_modulus, lambda = result.bulk_modulus - 2.0 / 3.0 * g;
      const double q = std::sqrt(0.5 * (1 + lambda / (lambda + 2 * g)));
      const double tau = g / q * std::sin(q), xx = -B + 2 * g * (1 - std::cos(q));
      const auto& stress = result.samples.back().stress;
      const double error = std::hypot(stress[3] - tau, stress[0] - xx) / g;
      // Explicit rates are of first order; Hughes-Winget turns the stress exactly, but adds the
      // increment of strain without the half turn it has made itself.
      if (last > 0.0) {
        EXPECT_NEAR(last / error, 2.0, 0.1) << preset_name;
      }
      last = error;
    }
    EXPECT_LE(last, 1e-2);
  }
}

/// Constant volume: tau = G sin gamma, sigma_xx = -B + G (1 - cos gamma). Each increment misses
/// half its turn of d gamma/2, so that the stress lags by an angle of d gamma/4, the deviator by
/// twice as much; the next term is smaller by d gamma.
TEST(ElementPathTest, HughesWingetLagsByHalfAStepInShear) {
  const MaterialPoint point(scene_of(elastic()), {}, 2);
  PointState state = point.at({-B, -B, -B, 0, 0, 0});
  const int steps = 200;
  const double d = 1.0 / steps;
  for (int n = 0; n < steps; ++n) state = point.advance(state, {0, d, 0, 0, 0, 0, 0, 0, 0});
  const double g = point.moduli().shear_modulus;
  const double error = std::hypot(state.stress[3] - g * std::sin(1.0),
                                  state.stress[0] + B - g * (1 - std::cos(1.0)));
  const double lag = 2 * std::sin(0.5) * 0.5 * d * g;
  EXPECT_NEAR(error, lag, 2 * d * lag);
}

/// Krieg & Krieg (1977), perfect plasticity under a constant deviatoric strain rate: the angle
/// between stress and strain rate falls as tan(angle/2) = tan(angle_0/2) exp(-2 G |e| / |s|).
TEST(ElementPathTest, ReturnMappingIsOfFirstOrderWhereTheStressTurns) {
  const MaterialPoint point(scene_of(soils()[1]), {}, 3);
  const double j = point.shown().at("k_c") + 3 * point.shown().at("alpha_phi") * B;
  double last = 0.0;
  for (const int steps : {50, 100, 200}) {
    PointState state = point.at({-B + j, -B - j, -B, 0, 0, 0});
    const double gamma = j / point.moduli().shear_modulus;  // |e| = gamma/sqrt 2, |s| = sqrt 2 j
    const double d = 0.5 * gamma / steps;
    for (int n = 0; n < steps; ++n) state = point.advance(state, {0, d, 0, d, 0, 0, 0, 0, 0});
    const double angle = 2 * std::atan(std::exp(-1.0));
    const double error = std::fabs(std::atan2(state.stress[0] + B, state.stress[3]) - angle);
    if (last > 0.0) {
      EXPECT_NEAR(last / error, 2.0, 0.1);
    }
    last = error;
  }
  EXPECT_LE(last, 1e-2);
}

TEST(ElementPathTest, RigidRotationReturnsTheStress) {
  const std::array<double, 6> start{-B, -3 * B, -2 * B, 0.5 * B, 0.2 * B, -0.3 * B};
  const auto error_after = [&](const std::string& preset_name, int turns) {
    const MaterialPoint point(scene_of(elastic(), preset_name), {}, 3);
    PointState state = point.at(start);
    const double w = 2 * std::numbers::pi / 1000, c = w / std::sqrt(14.0);  // about (1, 2, 3)
    for (int n = 0; n < 1000 * turns; ++n) {
      state = point.advance(state, {0, -3 * c, 2 * c, 3 * c, 0, -c, -2 * c, c, 0});
    }
    double sum = 0.0, size = 0.0;
    for (std::size_t k = 0; k < 6; ++k) {
      const double share = k < 3 ? 1.0 : 2.0;
      sum += share * (state.stress[k] - start[k]) * (state.stress[k] - start[k]);
      size += share * start[k] * start[k];
    }
    return std::sqrt(sum / size);
  };
  EXPECT_LE(error_after("modern", 1), 1e-4);
  EXPECT_LE(error_after("modern", 10), 1e-3);
  EXPECT_GE(error_after("paper", 1), 1e-3);  // the explicit rate does not pass
}

TEST(ElementPathTest, ReadsNothingThatMakesNoSense) {
  const Scene scene = scene_of(clay());
  const double bad = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(run_element(scene, {ElementPath::triaxial, "rok"}), Error);
  EXPECT_THROW(run_element(scene, {ElementPath::triaxial, {}, -1.0}), Error);
  EXPECT_THROW(run_element(scene, {ElementPath::triaxial, {}, B, bad}), Error);
  EXPECT_THROW(run_element(scene, {ElementPath::triaxial, {}, B, 0.0}), Error);
  EXPECT_THROW(run_element(scene, {ElementPath::triaxial, {}, B, 0.1, 0}), Error);
  EXPECT_THROW(run_element(scene, {ElementPath::triaxial, {}, B, 0.1, 2147483647}), Error);
  EXPECT_THROW(run_element(scene, {static_cast<ElementPath>(4)}), Error);
  EXPECT_THROW(run_element(scene, {static_cast<ElementPath>(-1)}), Error);
  EXPECT_THROW(MaterialPoint(scene, "rok", 3), Error);
  EXPECT_THROW(MaterialPoint(scene, {}, 4), Error);
}

TEST(ElementPathTest, MohrCoulombFailsAtCoulombsStrengthOnEveryPath) {
  const double c = 10e3, phi = 30.0 * degree, sine = std::sin(phi), cosine = std::cos(phi);
  const double passive = (B * (1 + sine) + 2 * c * cosine) / (1 - sine),
               active = (B * (1 - sine) - 2 * c * cosine) / (1 + sine);
  for (const std::string preset_name : {"modern", "paper"}) {
    for (const double psi : {0.0, 12.0, 30.0}) {
      const Material soil{"soil", MohrCoulomb{100e6, 0.3, c, phi, psi * degree}, 2000.0};
      for (const int dimension : {2, 3}) {
        const Scene scene = scene_of(soil, preset_name, dimension);
        const ElementSample pressed = driven(scene, ElementPath::triaxial, 0.05).samples.back(),
                            pulled = driven(scene, ElementPath::triaxial, -0.05).samples.back(),
                            plane = driven(scene, ElementPath::plane_strain, 0.05).samples.back();
        EXPECT_NEAR(-pressed.stress[1], passive, 1e-6 * passive) << psi;
        EXPECT_NEAR(-pulled.stress[1], active, 1e-6 * passive) << psi;
        EXPECT_NEAR(-plane.stress[1], passive, 1e-6 * passive) << psi;
        EXPECT_NEAR(pressed.yield_function, 0.0, 1e-6 * passive);
        // Flow of both planes at the edge: volume over axial strain -2 sin psi/(1 - sin psi).
        const double sp = std::sin(psi * degree), axial = 0.05 - (passive - B) / 100e6;
        EXPECT_NEAR(pressed.plastic_volumetric_strain, 2 * sp / (1 - sp) * axial, 1e-5);
      }
    }
  }
}

TEST(ElementPathTest, SofteningEndsAtTheResidualStrengthOfBothModels) {
  const double residual = 20e3;  // q = 2 c without friction
  const auto softened = [](auto clay) {
    clay.residual_cohesion = 10e3;
    clay.softening_slip = 0.01;
    return clay;
  };
  const DruckerPrager cone{100e6, 0.3, 30e3, 0.0, 0.0, Cone::plane_strain};
  const MohrCoulomb coulomb{100e6, 0.3, 30e3, 0.0};
  // The cone first yields where s2 = nu q is not yet the mean of the others: q = c sqrt(3/(1 - nu +
  // nu^2)); softening then races the growth to 2 c.
  const double nu = 0.3, strength = 60e3,
               first_yield_of_cone = 30e3 * std::sqrt(3.0 / (1.0 - nu + nu * nu));
  const std::pair<SoilModel, double> clays[]{{softened(cone), first_yield_of_cone},
                                             {softened(coulomb), strength}};
  for (const auto& [model, first_yield] : clays) {
    const ElementResult result =
        driven(scene_of({"clay", model, 2000.0}), ElementPath::plane_strain, 0.1, 2000);
    double peak = 0.0;
    for (const ElementSample& sample : result.samples) peak = std::fmax(peak, deviator(sample));
    // A step of 5e-5 costs up to 3 sqrt(3) 2.5 dx/slip 5e-5 2/sqrt(3) of the 40 kPa that are lost.
    const double of_one_step = 3.0 * 2.5 * 0.25 / 0.01 * 5e-5 * 2.0 * 40e3;
    EXPECT_GE(peak, first_yield - of_one_step);
    EXPECT_LE(peak, strength * (1.0 + 1e-9));
    // Shear strain 0.2 in a band of 2.5 spacings of 0.25 m: twelve times the softening slip.
    EXPECT_NEAR(deviator(result.samples.back()), residual, 1e-3 * residual);
  }
}

}  // namespace
}  // namespace scarp::test
