// SPDX-License-Identifier: BSD-3-Clause
/// Bishop's method against published factors and closed forms.
#include "validation/bishop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/errors.hpp"

namespace scarp::validation {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// 2:1, 10 m high, c/(gamma H) = 0.05, phi = 20 deg; `foundation` below the toe.
Slope griffiths_lane(double foundation) {
  return {{{{0, 10}}, {{12, 10}}, {{32, 0}}, {{52, 0}}}, -foundation, 20e3, 10e3, 20 * degree};
}

Slope sample_1() {
  return {{{{0, 15}}, {{12, 15}}, {{32, 5}}, {{45, 5}}}, 0, 2000 * 9.81, 10e3, 20 * degree};
}

TEST(BishopTest, GriffithsLaneExample1HasTheChartsFactor) {
  // Bishop and Morgenstern's chart gives 1.380, read to three digits from a table interpolated in
  // two parameters: half a per cent.
  EXPECT_NEAR(bishop_search(griffiths_lane(0.0)).factor_of_safety, 1.380, 0.005 * 1.380);
}

TEST(BishopTest, GriffithsLaneExample2FailsThroughTheToe) {
  // With a foundation of H/2 the worst circle stays at the toe (Spencer, toe: 1.366; half a per
  // cent, since the two methods treat side forces differently).
  const BishopResult result = bishop_search(griffiths_lane(5.0));
  EXPECT_NEAR(result.factor_of_safety, 1.366, 0.005 * 1.366);
  EXPECT_NEAR(result.exit[0], 32.0, 0.5);
}

TEST(BishopTest, GriffithsLaneExample2BaseCircleIsSafer) {
  // The best circle tangent to the firm base: Bishop and Morgenstern's chart gives 1.752, XSLOPE's
  // forced circle 1.70. The two published figures are the bounds, with half their last digit.
  const Slope slope = griffiths_lane(5.0);
  double least = 10.0;
  for (double x = 15.0; x < 35.0; x += 0.5) {
    for (double y = 8.0; y < 40.0; y += 0.5) {
      const auto result = bishop_circle(slope, {x, y, y + 5.0});
      if (result) least = std::min(least, result->factor_of_safety);
    }
  }
  EXPECT_GE(least, 1.695);
  EXPECT_LE(least, 1.7525);
}

TEST(BishopTest, Sample1HasTheIndependentFactor) {
  // 1.377 by an independent search, printed to four digits.
  EXPECT_NEAR(bishop_search(sample_1()).factor_of_safety, 1.377, 0.005 * 1.377);
}

TEST(BishopTest, FactorWithoutFrictionIsTheMomentRatio) {
  // phi = 0: F = c L R / M. The arc length L and the moment M of the sliding mass are exact here;
  // M from the polygon of ground line and arc, of which 20000 chords miss 1e-8 of the area.
  Slope slope = griffiths_lane(5.0);
  slope.friction_angle = 0.0;
  const Circle circle{24.0, 16.0, 20.0};
  const auto result = bishop_circle(slope, circle, 2000);
  ASSERT_TRUE(result);
  const auto angle = [&](const std::array<double, 2>& p) {
    return std::atan2(p[0] - circle.x, circle.y - p[1]);
  };
  const double from = angle(result->entry), to = angle(result->exit);
  std::vector<std::array<double, 2>> mass;
  constexpr int chords = 20000;
  for (int i = 0; i <= chords; ++i) {
    const double a = from + (to - from) * i / chords;
    mass.push_back(
        {circle.x + circle.radius * std::sin(a), circle.y - circle.radius * std::cos(a)});
  }
  mass.push_back({32.0, 0.0});
  mass.push_back({12.0, 10.0});
  double moment = 0.0;
  for (std::size_t i = 0; i < mass.size(); ++i) {
    const auto& p = mass[i];
    const auto& q = mass[(i + 1) % mass.size()];
    const double cross = p[0] * q[1] - q[0] * p[1];
    // first moment of the area about the centre's vertical
    moment += cross / 6.0 * (p[0] + q[0] - 3.0 * circle.x);
  }
  const double expected = slope.cohesion * circle.radius * circle.radius * (to - from) /
                          (slope.unit_weight * std::fabs(moment));
  // Slices of equal angle: the error falls with the square of their number, 1/2000^2 and a factor.
  EXPECT_NEAR(result->factor_of_safety, expected, 1e-5 * expected);
}

TEST(BishopTest, FactorConvergesWithSlices) {
  const Circle circle{28.53, 27.6, 22.865};
  const Slope slope = sample_1();
  const double fine = bishop_circle(slope, circle, 3200)->factor_of_safety;
  const double at_50 = std::fabs(bishop_circle(slope, circle, 50)->factor_of_safety - fine);
  const double at_200 = std::fabs(bishop_circle(slope, circle, 200)->factor_of_safety - fine);
  EXPECT_LT(at_50, 1e-3 * fine);
  // Second order gives a sixteenth; the pieces between corners are not cut evenly, so an eighth.
  EXPECT_LT(at_200, at_50 / 8.0);
}

TEST(BishopTest, StrengthReductionDividesTheFactor) {
  // c/F and tan(phi)/F leave every m unchanged, so the factor falls by exactly F (round-off of 100
  // iterations).
  const Circle circle{28.53, 27.6, 22.865};
  Slope slope = sample_1();
  const double full = bishop_circle(slope, circle)->factor_of_safety;
  slope.cohesion /= 1.4;
  slope.friction_angle = std::atan(std::tan(slope.friction_angle) / 1.4);
  EXPECT_NEAR(bishop_circle(slope, circle)->factor_of_safety, full / 1.4, 1e-11);
}

TEST(BishopTest, MirroredSlopeHasTheSameFactor) {
  Slope mirrored = sample_1();
  mirrored.surface = {{{0, 5}}, {{13, 5}}, {{33, 15}}, {{45, 15}}};
  const double factor = bishop_search(sample_1()).factor_of_safety;
  // Two searches stop within their last step of 1e-6 of the depth.
  EXPECT_NEAR(bishop_search(mirrored).factor_of_safety, factor, 1e-5);
}

TEST(BishopTest, InvalidCirclesAreRefused) {
  const Slope slope = sample_1();
  EXPECT_FALSE(bishop_circle(slope, {28.5, 27.6, 28.0}));  // below the base
  EXPECT_FALSE(bishop_circle(slope, {28.5, 60.0, 10.0}));  // above the ground
  EXPECT_FALSE(bishop_circle(slope, {5.0, 20.0, 8.0}));    // level ground: does not slide
  EXPECT_FALSE(bishop_circle(slope, {40.0, 30.0, 60.0}));  // beyond the ends
}

TEST(BishopTest, SearchWithoutAValidCircleIsAnError) {
  const Slope level{{{{0, 5}}, {{45, 5}}}, 0, 20e3, 10e3, 20 * degree};
  EXPECT_THROW(bishop_search(level), Error);
}

}  // namespace
}  // namespace scarp::validation
