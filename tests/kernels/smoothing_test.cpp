// SPDX-License-Identifier: BSD-3-Clause
/// Smoothing functions: unit integral, derivative, support, and the two ways of writing them.
#include "kernels/smoothing/smoothing_reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "kernels/smoothing/list.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

class SmoothingTest : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  const int index_ = std::get<0>(GetParam()), dimension_ = std::get<1>(GetParam());
  const ReferenceSmoothing which_ = static_cast<ReferenceSmoothing>(index_);
  const SmoothingForm& form_ = smoothing_functions[static_cast<std::size_t>(index_)];
  const double h_ = 0.7;
  // alpha_D
  const double scale_ = form_.normalisation(dimension_) / std::pow(h_, dimension_);
};

TEST_P(SmoothingTest, IntegratesToOne) {
  // Simpson's rule with 2000 steps on each smooth piece: h^4 error far below 1e-10.
  double integral = 0.0;
  for (const double begin : {0.0, 1.0}) {
    constexpr int steps = 2000;
    for (int k = 0; k <= steps; ++k) {
      const double q = begin + static_cast<double>(k) / steps, r = q * h_;
      const double weight = k == 0 || k == steps ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
      const double shell =
          dimension_ == 2 ? 2.0 * std::numbers::pi * r : 4.0 * std::numbers::pi * r * r;
      integral += weight / 3.0 * h_ / steps * shell * scale_ * form_.shape(q);
    }
  }
  EXPECT_NEAR(integral, 1.0, 1e-10);
}

TEST_P(SmoothingTest, EqualsThePiecesOfTheLiterature) {
  for (int k = 0; k <= 250; ++k) {
    const double q = 0.01 * k;
    // A few roundings of terms that are up to 20 times W(0) before they cancel.
    const double tolerance = 2e-14 * scale_ * form_.shape(0.0);
    EXPECT_NEAR(scale_ * form_.shape(q), smoothing_value_reference(which_, dimension_, q * h_, h_),
                tolerance)
        << "q = " << q;
    EXPECT_NEAR(scale_ / h_ * form_.slope(q),
                smoothing_slope_reference(which_, dimension_, q * h_, h_), tolerance / h_)
        << "q = " << q;
  }
}

TEST_P(SmoothingTest, SlopeIsTheDerivativeOfTheValue) {
  for (int k = 1; k < 210; ++k) {
    const double q = 0.01 * k, step = 1e-5;
    const double difference = (form_.shape(q + step) - form_.shape(q - step)) / (2.0 * step);
    // Central difference: third derivative (at most 50) times step^2/6, or a jump of the second at
    // the joints (at most 12) times step; and 1e-16 shape(0)/step of rounding.
    EXPECT_NEAR(form_.slope(q), difference, 1.3e-4 * (k % 100 == 0) + 1e-8) << "q = " << q;
  }
}

TEST_P(SmoothingTest, VanishesBeyondItsSupportAndFallsWithin) {
  EXPECT_EQ(form_.shape(2.0), 0.0);
  EXPECT_EQ(form_.slope(2.0), 0.0);
  EXPECT_EQ(form_.shape(1e8), 0.0);
  EXPECT_EQ(form_.slope(1e8), 0.0);
  for (double q = 0.005; q < 2.0; q += 0.01) {
    EXPECT_GT(form_.shape(q), 0.0);
    EXPECT_LT(form_.slope(q), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(
    AllFunctions, SmoothingTest,
    testing::Combine(testing::Range(0, static_cast<int>(smoothing_functions.size())),
                     testing::Values(2, 3)),
    [](const auto& p) {
      return std::string(smoothing_functions[std::get<0>(p.param)].name) + "_" +
             std::to_string(std::get<1>(p.param)) + "D";
    });

TEST(SmoothingRatioTest, MatchesTheExponentsTheRegisterNames) {
  // n = W(0)/W(dx) at h = 1.2 dx: 2.55 in the paper is the cubic spline's, not its own function's.
  EXPECT_NEAR(cubic_spline.shape(0.0) / cubic_spline.shape(1.0 / 1.2), 2.549, 5e-4);
  EXPECT_NEAR(yang_liu.shape(0.0) / yang_liu.shape(1.0 / 1.2), 3.801, 5e-4);
}

}  // namespace
}  // namespace scarp::test
