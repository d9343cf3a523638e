// SPDX-License-Identifier: BSD-3-Clause
/// Element paths of the Drucker-Prager model against closed forms.
#include "kernels/constitutive/drucker_prager.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/constitutive/stress_pass.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

constexpr double degree = 0.017453292519943295;
constexpr double band = 1e-3;  // of the closed forms; the return itself is exact

DruckerPrager::Constants soil(double c, double phi, double psi, Cone cone) {
  return DruckerPrager{1e8, 0.3, c, phi * degree, psi * degree, cone}.prepare({});
}

/// Of one step of length 1, whose gradient is the increment of strain.
StressPassConstants one_step() {
  StressPassConstants k{};
  k.leap = 1.0;
  k.plastic_share = 1.0;
  k.hughes_winget = true;
  return k;
}

/// A material point driven by strain increments (leap = 1: gradient = increment).
struct Element {
  DruckerPrager::Constants constants;
  SymTensor<double> stress{};
  SymTensor<double> strain{};
  SymTensor<double> plastic_strain{};
  double accumulated = 0.0;

  static Tensor<double> diagonal(double x, double y, double z) {
    Tensor<double> l{};
    l.m[0][0] = x;
    l.m[1][1] = y;
    l.m[2][2] = z;
    return l;
  }
  SymTensor<double> tried(const Tensor<double>& increment) const {
    SymTensor<double> result = stress;
    History<double, 1> history{};
    advance_stress_point<DruckerPrager>(one_step(), constants, increment, stress,
                                        SymTensor<double>{}, 0.0, history, result);
    return result;
  }
  void apply(const Tensor<double>& increment) {
    const SymTensor<double> current = stress;
    History<double, 1> history{};
    const auto step = advance_stress_point<DruckerPrager>(
        one_step(), constants, increment, current, SymTensor<double>{}, 0.0, history, stress);
    strain = strain + step.total;
    plastic_strain = plastic_strain + step.plastic;
    accumulated += history.change[0];
  }
  double yield() const { return DruckerPrager::yield_function(constants, stress, {}); }
};

/// Root of a monotonic, piecewise smooth function by bisection.
template <class F>
double bisect(F f, double low, double high) {
  const bool rising = f(high) > f(low);
  for (int k = 0; k < 80; ++k) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0.0) == rising ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

/// Axial compression at constant lateral stress -confining, in 3D (both sides free) or plane strain
/// (one).
Element compressed(const DruckerPrager::Constants& constants, double confining, bool plane_strain,
                   double axial_strain, int steps) {
  Element e{constants};
  e.stress = isotropic(-confining);
  const double step = -axial_strain / steps;
  for (int n = 0; n < steps; ++n) {
    const auto increment = [&](double lateral) {
      return Element::diagonal(lateral, step, plane_strain ? 0.0 : lateral);
    };
    const double lateral = bisect([&](double l) { return e.tried(increment(l)).xx + confining; },
                                  -3.0 * std::fabs(step), 3.0 * std::fabs(step));
    e.apply(increment(lateral));
  }
  return e;
}

class ConeTest : public testing::TestWithParam<Cone> {};

TEST_P(ConeTest, TriaxialCompressionFailsAtTheClosedForm) {
  for (const double psi : {0.0, 9.0, 20.0}) {
    for (const double confining : {0.0, 2e4, 1e5}) {
      const DruckerPrager::Constants c = soil(1e4, 20.0, psi, GetParam());
      const Element e = compressed(c, confining, false, 0.05, 500);
      // f = 0 with J = (A - B)/sqrt(3), I1 = -(A + 2 B).
      const double s3 = std::sqrt(3.0);
      const double axial = (confining / s3 + c.cone.k_c + 2.0 * c.cone.alpha_phi * confining) /
                           (1.0 / s3 - c.cone.alpha_phi);
      EXPECT_NEAR(-e.stress.yy, axial, band * axial) << "psi " << psi << " confining " << confining;
      EXPECT_NEAR(e.stress.xx, -confining, 1e-6 * axial);
      // Flow along s/(2 J) + alpha_psi I: volume over axial strain.
      const double ratio = 3.0 * c.cone.alpha_psi / (c.cone.alpha_psi - 1.0 / s3);
      EXPECT_NEAR(trace(e.plastic_strain) / e.plastic_strain.yy, ratio, band);
      const SymTensor<double> d = deviator(e.plastic_strain);
      EXPECT_NEAR(e.accumulated, std::sqrt(2.0 / 3.0 * contract(d, d)), band * e.accumulated);
      EXPECT_GT(e.accumulated, 0.01);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllCones, ConeTest,
                         testing::Values(Cone::plane_strain, Cone::outer, Cone::inner));

TEST(DruckerPragerTest, OuterConeIsCoulombInTriaxialCompression) {
  const double c = 1e4, phi = 33.0 * degree, confining = 5e4;
  const double n = (1.0 + std::sin(phi)) / (1.0 - std::sin(phi));
  const Element e = compressed(soil(c, 33.0, 0.0, Cone::outer), confining, false, 0.05, 500);
  const double coulomb = confining * n + 2.0 * c * std::sqrt(n);
  EXPECT_NEAR(-e.stress.yy, coulomb, band * coulomb);
}

TEST(DruckerPragerTest, PlaneStrainFailsAtTheNonAssociatedClosedForm) {
  for (const double psi : {0.0, 9.0, 20.0}) {
    for (const double confining : {0.0, 2e4, 1e5}) {
      const DruckerPrager::Constants c = soil(1e4, 20.0, psi, Cone::plane_strain);
      const Element e = compressed(c, confining, true, 0.2, 2000);
      // No plastic strain across: s_zz = -2 b J, so J splits into w J in the plane and b J along
      // it.
      const double a = c.cone.alpha_phi, b = c.cone.alpha_psi, w = std::sqrt(1.0 - 3.0 * b * b);
      const double j = (c.cone.k_c + 3.0 * a * confining) / (1.0 - 3.0 * a * (w + b));
      const double axial = confining + 2.0 * w * j;
      EXPECT_NEAR(-e.stress.yy, axial, band * axial) << "psi " << psi << " confining " << confining;
      EXPECT_NEAR(deviator(e.stress).zz, -2.0 * b * j, band * j);
    }
  }
}

TEST(DruckerPragerTest, AssociatedPlaneStrainConeIsCoulomb) {
  const double c = 1e4, phi = 20.0 * degree, confining = 5e4;
  const double n = (1.0 + std::sin(phi)) / (1.0 - std::sin(phi));
  const Element e = compressed(soil(c, 20.0, 20.0, Cone::plane_strain), confining, true, 0.2, 2000);
  const double coulomb = confining * n + 2.0 * c * std::sqrt(n);
  EXPECT_NEAR(-e.stress.yy, coulomb, band * coulomb);
}

TEST(DruckerPragerTest, SimpleShearWithoutFrictionStopsAtTheStrength) {
  const DruckerPrager::Constants c = soil(2e4, 0.0, 0.0, Cone::plane_strain);
  Element e{c};
  e.stress = isotropic(-5e4);
  const int steps = 1000;
  const double total = 0.05;
  Tensor<double> shear{};
  shear.m[0][1] = total / steps;
  for (int n = 0; n < steps; ++n) e.apply(shear);
  EXPECT_NEAR(c.cone.k_c, 2e4, 1e-9);
  // Spin tilts the stress by about k/G = 5e-4 against the shear: a second-order loss of k_xy.
  EXPECT_NEAR(e.stress.xy, c.cone.k_c, band * c.cone.k_c);
  EXPECT_NEAR(trace(e.stress), -1.5e5, 1e-6);
  const double plastic_shear = total - c.cone.k_c / c.elastic.shear_modulus;
  EXPECT_NEAR(e.accumulated, plastic_shear / std::sqrt(3.0), band * e.accumulated);
}

TEST(DruckerPragerTest, IsotropicTensionEndsAtTheApex) {
  for (const double psi : {0.0, 20.0}) {
    const DruckerPrager::Constants c = soil(1e4, 20.0, psi, Cone::outer);
    Element e{c};
    e.stress = {-1e4, -2e4, -3e4, 1e3, -2e3, 3e3};
    for (int n = 0; n < 100; ++n) e.apply(Element::diagonal(1e-5, 1e-5, 1e-5));
    EXPECT_NEAR(trace(e.stress), c.cone.k_c / c.cone.alpha_phi,
                1e-9 * c.cone.k_c / c.cone.alpha_phi);
    EXPECT_NEAR(root_j2(deviator(e.stress)), 0.0, 1e-9 * c.cone.k_c);
    EXPECT_GT(trace(e.plastic_strain), 1e-4);
  }
}

TEST(DruckerPragerTest, SoilWithoutCohesionKeepsNoTension) {
  Element e{soil(0.0, 33.0, 0.0, Cone::outer)};
  e.stress = isotropic(-1e4);
  for (int n = 0; n < 100; ++n) e.apply(Element::diagonal(1e-5, 1e-5, 1e-5));
  EXPECT_EQ(trace(e.stress), 0.0);
  EXPECT_EQ(root_j2(deviator(e.stress)), 0.0);
}

TEST(DruckerPragerTest, ReturnDoesNotMoveWhatIsInside) {
  const DruckerPrager::Constants c = soil(1e4, 20.0, 9.0, Cone::plane_strain);
  SymTensor<double> s{-5e4, -6e4, -5.5e4, 1e3, 2e3, -1e3};
  const SymTensor<double> before = s;
  EXPECT_EQ(return_to_cone(c.elastic, c.cone, s), 0.0);
  EXPECT_EQ(s.xx, before.xx);
  EXPECT_EQ(s.zx, before.zx);
}

TEST(DruckerPragerTest, ReturnedStressLiesOnTheSurface) {
  const DruckerPrager::Constants c = soil(1e4, 20.0, 9.0, Cone::plane_strain);
  for (const double shear : {5e4, 1e5, 1e7}) {
    SymTensor<double> s{-5e4, -6e4, -5.5e4, shear, 2e3, -1e3};
    EXPECT_GT(return_to_cone(c.elastic, c.cone, s), 0.0);
    EXPECT_NEAR(yield_function(c.cone, root_j2(deviator(s)), trace(s)), 0.0, 1e-12 * shear);
  }
}

TEST(DruckerPragerTest, ReductionDividesTheStrength) {
  const DruckerPrager clay{1e8, 0.3, 1e4, 20.0 * degree, 19.0 * degree, Cone::outer};
  const ConeConstants full = clay.prepare({1.0}).cone, half = clay.prepare({2.0}).cone;
  const double phi = std::atan(0.5 * std::tan(20.0 * degree));
  const ConeConstants expected = cone_constants({5e3, phi, phi}, Cone::outer);
  EXPECT_DOUBLE_EQ(half.alpha_phi, expected.alpha_phi);
  EXPECT_DOUBLE_EQ(half.k_c, expected.k_c);
  EXPECT_DOUBLE_EQ(half.alpha_psi, expected.alpha_psi);  // 19 degrees are above the reduced phi
  EXPECT_LT(full.alpha_psi, full.alpha_phi);
}

}  // namespace
}  // namespace scarp::test
