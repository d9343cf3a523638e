// SPDX-License-Identifier: BSD-3-Clause
/// Mohr-Coulomb and softening against published returns and closed forms; the vector pass is
/// compared with an oracle in stress_pass_test.cpp.
#include "kernels/constitutive/mohr_coulomb.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <random>

#include "kernels/constitutive/drucker_prager.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

constexpr double degree = 0.017453292519943295;

MohrCoulomb soil(double c, double phi, double psi) {
  return {1e8, 0.3, c, phi * degree, psi * degree};
}

struct Return {
  double cohesion, phi, psi;  ///< [kPa, deg]
  double trial[3], back[3];   ///< [kPa]
};
/// E = 100 MPa, nu = 0.3: plane, both edges, an edge in tension, apex, Tresca.
constexpr Return returns[]{{10, 20, 9, {-20, -60, -150}, {-52.55313, -65.49114, -135.75067}},
                           {10, 20, 9, {-20, -140, -150}, {-54.79321, -140.31956, -140.31956}},
                           {10, 20, 9, {-20, -25, -150}, {-49.59001, -49.59001, -129.70708}},
                           {10, 20, 9, {10, 0, -60}, {-9.92993, -9.92993, -48.81611}},
                           {10, 20, 9, {60, 40, 20}, {27.47477, 27.47477, 27.47477}},
                           {30, 0, 0, {-10, -40, -100}, {-25, -40, -85}}};

TEST(MohrCoulombTest, ReturnsAreThePublishedOnes) {
  for (const Return& one : returns) {
    const auto c = soil(1e3 * one.cohesion, one.phi, one.psi).prepare({});
    double s[3];
    for (int i = 0; i < 3; ++i) s[i] = 1e3 * one.trial[i];
    return_to_coulomb(c.elastic, c.surface, s);
    // Five decimals of a kilopascal are given.
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(1e-3 * s[i], one.back[i], 5e-6);
  }
}

SymTensor<double> tensor_of(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)};
}

TEST(MohrCoulombTest, PrincipalStressesAreThoseOfAnEigensolverHoweverNearTheyAre) {
  std::mt19937 engine(7);
  std::normal_distribution<double> normal;
  for (const double gap : {1.0, 1e-6, 1e-12, 1e-15, 0.0}) {
    for (int n = 0; n < 200; ++n) {
      Eigen::Matrix3d turn = Eigen::Matrix3d::NullaryExpr([&] { return normal(engine); });
      turn = Eigen::Matrix3d(turn.householderQr().householderQ());
      const Eigen::Vector3d values(1.0 + gap, 1.0, n % 2 == 0 ? -2.0 : 1.0 - gap);
      const Eigen::Matrix3d stress = turn * values.asDiagonal() * turn.transpose();
      const Principal<double> s = principal(tensor_of(0.5 * (stress + stress.transpose())));
      for (int k = 0; k < 3; ++k) EXPECT_NEAR(s.value[k], values[k], 3e-15) << gap;
      // Ten roundings of entries of size 2.
      const SymTensor<double> again = along_axes(s, s.value);
      EXPECT_NEAR(again.xx, stress(0, 0), 5e-15);
      EXPECT_NEAR(again.xy, stress(0, 1), 5e-15);
      EXPECT_NEAR(again.yz, stress(1, 2), 5e-15);
    }
  }
}

/// A point under strain increments without rotation.
template <class Model>
struct Point {
  typename Model::Constants constants;
  SymTensor<double> stress;
  double plastic_strain = 0.0, density = 2000.0;

  SymTensor<double> tried(const SymTensor<double>& strain) const {
    Point copy = *this;
    copy.apply(strain);
    return copy.stress;
  }
  void apply(const SymTensor<double>& strain) {
    History<double, 1> history{{plastic_strain}, {0.0}};
    Model::update(constants, StrainIncrement<double>{strain, {}, density, 1.0}, stress, history);
    plastic_strain += history.change[0];
  }
  /// Axial compression with the lateral stress held, both sides free or one held in its place.
  void compress(double step, bool plane_strain) {
    const double held = stress.xx;
    double low = -3.0 * step, high = 3.0 * step;
    const auto strain = [&](double lateral) {
      return SymTensor<double>{lateral, -step, plane_strain ? 0.0 : lateral, 0.0, 0.0, 0.0};
    };
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      (tried(strain(middle)).xx > held ? high : low) = middle;
    }
    apply(strain(0.5 * (low + high)));
  }
};

TEST(MohrCoulombTest, CompressionFailsAtCoulombsStrengthWithAndWithoutPlaneStrain) {
  // In plane strain the middle stress lies between the others whatever psi is, as it has no part in
  // the strength: no choice of a cone is needed.
  const double confining = 5e4, phi = 20.0 * degree, c = 1e4;
  const double n = (1.0 + std::sin(phi)) / (1.0 - std::sin(phi));
  const double strength = confining * n + 2.0 * c * std::sqrt(n);
  for (const bool plane_strain : {false, true}) {
    for (const double psi : {0.0, 9.0, 20.0}) {
      Point<MohrCoulomb> point{soil(c, 20.0, psi).prepare({}), isotropic(-confining)};
      for (int k = 0; k < 200; ++k) point.compress(1e-4, plane_strain);
      EXPECT_NEAR(-point.stress.yy, strength, 1e-9 * strength) << plane_strain << " psi " << psi;
    }
  }
}

TEST(MohrCoulombTest, TensionStopsAtTheCutOff) {
  MohrCoulomb clay = soil(1e4, 20.0, 0.0);
  clay.tensile_strength = 3e3;
  Point<MohrCoulomb> point{clay.prepare({}), isotropic(-1e4)};
  for (int k = 0; k < 100; ++k) point.apply({1e-5, 0.0, 0.0, 0.0, 0.0, 0.0});
  EXPECT_NEAR(point.stress.xx, 3e3, 1e-9);
  EXPECT_LT(point.stress.yy, 3e3);
  for (int k = 0; k < 100; ++k) point.apply({1e-5, 1e-5, 1e-5, 0.0, 0.0, 0.0});
  EXPECT_NEAR(trace(point.stress), 9e3, 1e-9);
  const auto halved = clay.prepare({2.0});
  EXPECT_EQ(halved.surface.tensile_strength, 1.5e3);
}

template <class Model>
Model softened(SofteningLaw law) {
  Model clay{.youngs_modulus = 1e8, .poisson_ratio = 0.3, .cohesion = 2e4, .friction_angle = 0.0};
  clay.residual_cohesion = 5e3;
  clay.softening = law;
  clay.softening_slip = 0.1;
  return clay;
}

/// Slip at constant volume in a band of 2.5 spacings: the shear strength is what the law says of
/// the slip, at any spacing.
template <class Model>
void expect_softening(SofteningLaw law, double slip, double strength) {
  for (const double spacing : {0.05, 0.1, 0.4}) {
    Point<Model> point{softened<Model>(law).prepare({1.0, spacing, 2000.0}), isotropic(-5e4)};
    const double band = 2.5 * spacing, elastic = 2e4 / point.constants.elastic.shear_modulus;
    const int steps = 20000;
    const double step = (slip / band + elastic) / steps;
    for (int k = 0; k < steps; ++k) point.apply({0.0, 0.0, 0.0, 0.5 * step, 0.0, 0.0});
    // First order in the step: the strength is that of its start. What the strength loses is
    // elastic strain that becomes slip: below 15 kPa/G = 4e-4, of which the law loses 1e-2 at most.
    EXPECT_NEAR(point.stress.xy, strength, 0.01 * 2e4) << spacing;
  }
}

TEST(SofteningTest, StrengthFallsOverTheSameSlipAtEverySpacing) {
  const double e = std::exp(-1.5);
  expect_softening<MohrCoulomb>(SofteningLaw::linear, 0.05, 12.5e3);
  expect_softening<MohrCoulomb>(SofteningLaw::linear, 0.2, 5e3);
  expect_softening<MohrCoulomb>(SofteningLaw::exponential, 0.05, 5e3 + 15e3 * e);
  expect_softening<DruckerPrager>(SofteningLaw::linear, 0.05, 12.5e3);
  expect_softening<DruckerPrager>(SofteningLaw::exponential, 0.05, 5e3 + 15e3 * e);
}

TEST(SofteningTest, ReductionDividesPeakAndResidualAlike) {
  const Softening s =
      softened<DruckerPrager>(SofteningLaw::linear).prepare({2.0, 0.1, 2e3}).softening;
  EXPECT_DOUBLE_EQ(s.peak.cohesion, 1e4);
  EXPECT_DOUBLE_EQ(s.residual_cohesion, 2.5e3);
}

TEST(SofteningTest, DilationEndsAtItsLimit) {
  MohrCoulomb sand = soil(0.0, 33.0, 15.0);
  sand.dilation_limit = 0.02;
  const auto constants = sand.prepare({1.0, 0.1, 2000.0});
  ASSERT_TRUE(constants.softening.acts);
  const double loosest = 2000.0 * std::exp(-0.02);
  EXPECT_DOUBLE_EQ(constants.softening.strength(0.0, 1.001 * loosest).dilation,
                   std::tan(15.0 * degree));
  EXPECT_EQ(constants.softening.strength(0.0, 0.999 * loosest).dilation, 0.0);
}

TEST(SofteningTest, ResidualsArePeaksWhereNothingIsSaid) {
  EXPECT_EQ(soil(1e4, 20.0, 0.0).residual_cohesion, 1e4);
  EXPECT_FALSE(soil(1e4, 20.0, 0.0).prepare({}).softening.acts);
  MohrCoulomb wrong = soil(1e4, 20.0, 0.0);
  wrong.residual_cohesion = 2e4;
  EXPECT_EQ(wrong.complaint()->parameter, 6u);
  wrong.residual_cohesion = 0.0;
  EXPECT_EQ(wrong.complaint()->parameter, 9u);  // no slip is given
}

}  // namespace
}  // namespace scarp::test
