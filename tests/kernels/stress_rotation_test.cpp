// SPDX-License-Identifier: BSD-3-Clause
/// Rotation of the stress with the material over whole turns.
#include "kernels/constitutive/stress_rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace scarp::test {
namespace {

using namespace kernels;

constexpr SymTensor<double> start{1.0, -0.3, 0.2, 0.4, 0.1, -0.5};
constexpr double pi = std::numbers::pi;

double norm(const SymTensor<double>& s) { return std::sqrt(contract(s, s)); }

/// Spin about an axis at one turn per unit time. v = omega x x gives w_xy = -omega_z.
Spin<double> spin_about(double x, double y, double z) {
  const double rate = 2.0 * pi / std::sqrt(x * x + y * y + z * z);
  return {-rate * x, -rate * y, -rate * z};
}

SymTensor<double> after_turns(const Spin<double>& w, int steps, double turns, bool hughes_winget) {
  SymTensor<double> s = start;
  const double dt = turns / steps;
  for (int k = 0; k < steps; ++k) {
    s = hughes_winget ? rotated(s, hughes_winget_rotation(w, dt)) : s + dt * jaumann_rate(s, w);
  }
  return s;
}

TEST(StressRotationTest, HughesWingetComesBackAfterATurn) {
  // Each step lags by (w dt)^3/12, a turn of 1000 steps by 2.1e-5 rad, which a tensor feels twice
  // at most.
  for (const auto& w :
       {spin_about(0, 0, 1), spin_about(1, 0, 0), spin_about(0, 1, 0), spin_about(1, -2, 3)}) {
    EXPECT_LT(norm(after_turns(w, 1000, 1.0, true) - start) / norm(start), 1e-4);
  }
}

TEST(StressRotationTest, HughesWingetKeepsInvariantsForAnyStep) {
  for (const int steps : {3, 10, 1000}) {
    const SymTensor<double> s = after_turns(spin_about(1, -2, 3), steps, 10.0, true);
    // One rounding of about 10 eps a step.
    EXPECT_NEAR(norm(s), norm(start), 1e-15 * 10 * (steps + 10));
    EXPECT_NEAR(trace(s), trace(start), 1e-15 * 10 * (steps + 10));
  }
}

TEST(StressRotationTest, HughesWingetTurnsTheWayTheMaterialDoes) {
  // A quarter turn about z, from x to y.
  const SymTensor<double> quarter = after_turns(spin_about(0, 0, 1), 1000, 0.25, true);
  EXPECT_NEAR(quarter.xx, start.yy, 1e-4);
  EXPECT_NEAR(quarter.yy, start.xx, 1e-4);
  EXPECT_NEAR(quarter.xy, -start.xy, 1e-4);
  EXPECT_NEAR(quarter.yz, start.zx, 1e-4);
  EXPECT_NEAR(quarter.zx, -start.yz, 1e-4);
}

TEST(StressRotationTest, BothRatesAgreeForSmallSteps) {
  for (const auto& w :
       {spin_about(0, 0, 1), spin_about(1, 0, 0), spin_about(0, 1, 0), spin_about(1, -2, 3)}) {
    const double dt = 1e-6;
    const SymTensor<double> exact = rotated(start, hughes_winget_rotation(w, dt));
    // The rates differ by (2 w dt)^2/2 = 8e-11 of the stress.
    EXPECT_LT(norm(exact - (start + dt * jaumann_rate(start, w))), 2e-10);
    EXPECT_GT(norm(exact - start), 1e-6);
  }
}

TEST(StressRotationTest, JaumannGrowsWithEveryTurn) {
  // In the plane of the spin the deviator turns at 2 w, so that an explicit step multiplies it by
  // sqrt(1 + (2 w dt)^2): 8.2 % a turn at 1000 steps. Parts that turn at w (out-of-plane shear)
  // grow by 2.0 %, the mean stress not at all: a stress of all three errs by a few per cent.
  const double dt = 1e-3, w = 2.0 * pi;
  const SymTensor<double> one = after_turns(spin_about(0, 0, 1), 1000, 1.0, false);
  const auto in_plane = [](const SymTensor<double>& s) {
    return std::hypot(0.5 * (s.xx - s.yy), s.xy);
  };
  const auto out_of_plane = [](const SymTensor<double>& s) { return std::hypot(s.yz, s.zx); };
  const double twice = std::pow(1.0 + 4.0 * w * w * dt * dt, 500),
               once = std::pow(1.0 + w * w * dt * dt, 500);
  EXPECT_NEAR(twice, 1.082, 1e-3);
  EXPECT_NEAR(in_plane(one) / in_plane(start), twice, 1e-10);
  EXPECT_NEAR(out_of_plane(one) / out_of_plane(start), once, 1e-10);
  EXPECT_NEAR(trace(one), trace(start), 1e-12);
  const SymTensor<double> ten = after_turns(spin_about(0, 0, 1), 10000, 10.0, false);
  EXPECT_NEAR(in_plane(ten) / in_plane(start), std::pow(twice, 10), 1e-9);
  // A uniaxial stress, for the figure in the register.
  EXPECT_GT(norm(one - start) / norm(start), 0.02);
}

}  // namespace
}  // namespace scarp::test
