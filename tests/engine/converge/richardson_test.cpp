// SPDX-License-Identifier: BSD-3-Clause
/// Error estimates against power laws, and what is said where there is none.

#include "engine/converge/richardson.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/converge/study.hpp"

namespace scarp {
namespace {

std::array<ValueAtSpacing, 3> power_law(double limit, double factor, double order,
                                        const std::array<double, 3>& spacings) {
  std::array<ValueAtSpacing, 3> samples;
  for (std::size_t k = 0; k < 3; ++k) {
    samples[k] = {spacings[k], limit + factor * std::pow(spacings[k], order)};
  }
  return samples;
}

std::array<ValueAtSpacing, 3> values(double a, double b, double c) {
  return {{{4.0, a}, {2.0, b}, {1.0, c}}};
}

TEST(Richardson, FindsOrderLimitAndErrorOfAPowerLaw) {
  // Values of size 1 with differences of 1e-2 and more: round-off in the order is below 1e-13.
  constexpr double round_off = 1e-11;
  for (const auto& spacings :
       {std::array{4.0, 2.0, 1.0}, std::array{2.0, 1.5, 1.0}, std::array{0.5, 0.3, 0.25}}) {
    for (const double order : {0.6, 1.0, 1.4, 2.0 - 1e-9}) {
      for (const double factor : {0.1, -0.1}) {
        const auto samples = power_law(1.0, factor, order, spacings);
        const ErrorEstimate estimate = estimate_error(samples);
        EXPECT_EQ(estimate.trend, Trend::converging);
        EXPECT_NEAR(estimate.observed_order, order, round_off);
        ASSERT_TRUE(estimate.extrapolated);
        EXPECT_NEAR(*estimate.extrapolated, 1.0, round_off);
        for (std::size_t k = 0; k < 3; ++k) {
          EXPECT_NEAR(estimate.error[k], 0.1 * std::pow(spacings[k], order), round_off);
        }
      }
    }
  }
}

TEST(Richardson, LimitsTheOrderThatItExtrapolatesWith) {
  const auto fast = power_law(1.0, 0.01, 4.0, {4.0, 2.0, 1.0});
  const ErrorEstimate above = estimate_error(fast);
  EXPECT_EQ(above.trend, Trend::order_limited);
  EXPECT_NEAR(above.observed_order, 4.0, 1e-11);
  EXPECT_EQ(above.order, most_order);
  EXPECT_GT(above.error[2], 0.01);  // never below the true one

  const ErrorEstimate below = estimate_error(power_law(1.0, 0.1, 0.2, {4.0, 2.0, 1.0}));
  EXPECT_EQ(below.trend, Trend::order_limited);
  EXPECT_NEAR(below.observed_order, 0.2, 1e-11);
  EXPECT_EQ(below.order, least_order);
}

TEST(Richardson, SaysSoWhereDifferencesGrow) {
  for (const auto& samples : {values(1.0, 1.15, 1.3225), values(1.0, 2.0, 3.0)}) {  // p < 0, p = 0
    const ErrorEstimate estimate = estimate_error(samples);
    EXPECT_EQ(estimate.trend, Trend::not_converging);
    EXPECT_LE(estimate.observed_order, 1e-12);
    EXPECT_FALSE(estimate.extrapolated);
    EXPECT_NEAR(estimate.error[2], 3.0 * (samples[2].value - 1.0) / samples[2].value, 1e-14);
    EXPECT_FALSE(spacing_for(estimate, samples, 0.05));
  }
}

TEST(Richardson, TakesThreeTimesTheSpreadWhereValuesGoUpAndDown) {
  const auto samples = values(2.1, 1.9, 2.0);
  const ErrorEstimate estimate = estimate_error(samples);
  EXPECT_EQ(estimate.trend, Trend::not_monotone);
  EXPECT_TRUE(std::isnan(estimate.observed_order));
  EXPECT_FALSE(estimate.extrapolated);
  for (const double error : estimate.error) EXPECT_NEAR(error, 0.3, 1e-15);
  EXPECT_FALSE(spacing_for(estimate, samples, 0.05));
  EXPECT_EQ(spacing_for(estimate, samples, 0.4), 4.0);
  EXPECT_EQ(estimate_error(values(1.0, 2.0, 2.0)).trend, Trend::not_monotone);
}

TEST(Richardson, EqualValuesHaveNoError) {
  for (const double value : {3.0, 0.0, -2.0}) {
    const auto samples = values(value, value, value);
    const ErrorEstimate estimate = estimate_error(samples);
    EXPECT_EQ(estimate.trend, Trend::equal);
    EXPECT_EQ(estimate.error[0], 0.0);
    EXPECT_EQ(spacing_for(estimate, samples, 0.02), 4.0);
  }
  // A component that is round-off beside its vector is no error of it.
  EXPECT_EQ(estimate_error(values(1e-16, -3e-16, 2e-15), 1.0).trend, Trend::equal);
}

TEST(Richardson, ValuesThatAreNotFiniteNameNothing) {
  const auto samples = values(1.0, NAN, 1.0);
  const ErrorEstimate estimate = estimate_error(samples);
  EXPECT_TRUE(std::isnan(estimate.error[2]));
  EXPECT_FALSE(spacing_for(estimate, samples, 0.05));
}

TEST(Richardson, SpacingForATargetLiesOnThePowerLaw) {
  const auto samples = power_law(1.0, 0.1, 1.0, {4.0, 2.0, 1.0});
  const ErrorEstimate estimate = estimate_error(samples);
  EXPECT_NEAR(*spacing_for(estimate, samples, 0.05), 0.5, 1e-11);
  EXPECT_NEAR(*spacing_for(estimate, samples, 0.2), 2.0, 1e-11);
  EXPECT_EQ(*spacing_for(estimate, samples, 0.9), 4.0);  // not above the coarsest
}

TEST(Richardson, RunTimeGrowsWithParticlesAndSteps) {
  EXPECT_DOUBLE_EQ(forecast_wall(10.0, 2.0, 1.0, 2), 80.0);
  EXPECT_DOUBLE_EQ(forecast_wall(10.0, 2.0, 1.0, 3), 160.0);
}

/// Two probes with errors of 0.1 h and 0.02 h and a wall with components.
Study two_probes() {
  Scene scene;
  scene.probes = {{"a", {}}, {"b", {}}};
  Wall wall;
  wall.name = "base";
  scene.walls = {wall};
  std::array<SpacingRun, 3> runs;
  for (std::size_t k = 0; k < 3; ++k) {
    const double h = 4.0 / std::pow(2.0, static_cast<double>(k)), a = 1.0 + 0.1 * h,
                 b = 1.0 + 0.02 * h;
    runs[k] = {
        h, 1.0 / (h * h * h), 100.0, 10.0, 5.0, false, {a, 0.0, -a, b, b, 0.0, a, 9.0, 0.0, 9.0}};
  }
  return assess(end_quantities(scene), runs, 2);
}

TEST(Study, AdviceFollowsTheWorstProbe) {
  const Study study = two_probes();
  ASSERT_EQ(study.quantities.size(), 10U);
  EXPECT_EQ(study.quantities[2].quantity.name, "a.displacement_y");
  EXPECT_EQ(study.quantities[9].quantity.name, "base.force_y");
  ASSERT_EQ(study.advice.size(), 2U);
  EXPECT_EQ(study.advice[0].decided_by, "a.displacement");
  EXPECT_NEAR(*study.advice[0].spacing, 0.5, 1e-9);
  EXPECT_NEAR(study.advice[0].wall_s, 8.0, 1e-7);
  EXPECT_NEAR(*study.advice[1].spacing, 0.2, 1e-9);
  EXPECT_TRUE(study.notes.empty());
}

TEST(Study, SaysThatDisplacementAfterFailureNeedNotConverge) {
  Study study = two_probes();
  std::array<SpacingRun, 3> runs = study.runs;
  runs[2].values[0] = 3.0;  // probe a jumps away
  runs[0].mass *= 1.02;
  std::vector<EndQuantity> quantities;
  for (const Convergence& c : study.quantities) quantities.push_back(c.quantity);
  study = assess(quantities, runs, 2);
  EXPECT_FALSE(study.advice[0].spacing);
  ASSERT_EQ(study.notes.size(), 2U);
  EXPECT_NE(study.notes[0].find("no internal length"), std::string::npos);
  EXPECT_NE(study.notes[1].find("mass"), std::string::npos);
}

}  // namespace
}  // namespace scarp
