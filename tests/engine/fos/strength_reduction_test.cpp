// SPDX-License-Identifier: BSD-3-Clause
/// Trials and searches of a factor of safety, on a coarse slope.
#include "engine/fos/strength_reduction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "tests/support/coarse_slope.hpp"

namespace scarp {
namespace {

using test::coarse_slope;
using test::message_of;
using test::settled_slope;

TEST(StrengthReductionTest, FindsTheFactorOfACoarseSlope) {
  StrengthReduction slope = settled_slope(coarse_slope());
  const FactorOfSafety found = find_factor(slope, {1.2, 1.6, 0.05}, {});
  ASSERT_TRUE(found.bracket.complete);
  // Bishop: 1.377. Ten spacings in the height are good for no better than ten per cent.
  EXPECT_NEAR(*found.bracket.factor(), 1.377, 0.1377);
  EXPECT_LT(slope.criterion().elastic, 0.01 * slope.criterion().limit);
  for (const Trial& trial : found.trials) {
    EXPECT_EQ(trial.fails,
              trial.displacement > slope.criterion().elastic + slope.criterion().limit);
    EXPECT_EQ(trial.fails, trial.end == TrialEnd::limit_crossed);
    // A cut by more than 1.5 takes longer in proportion.
    EXPECT_LE(trial.time, 1.3 * slope.criterion().ramp + slope.criterion().window);
  }
  // What was taken to stand early stands to the end of the window as well.
  Criterion whole = slope.criterion();
  whole.early_stop = false;
  StrengthReduction same(slope.settled().clone(), whole);
  for (const Trial& trial : found.trials) {
    if (trial.fails) continue;
    const std::optional<Trial> longer = same.respond(trial.reduction, {});
    EXPECT_FALSE(longer->fails) << trial.reduction;
    EXPECT_EQ(longer->end, TrialEnd::window_over);
  }
  // Without a probe the soil that moves most is judged: it moves no less.
  Scene bare = coarse_slope();
  bare.probes.clear();
  StrengthReduction blind = settled_slope(bare);
  blind.measure_elastic({});
  EXPECT_EQ(blind.criterion().probe, "");
  EXPECT_TRUE(blind.respond(*found.bracket.fails, {})->fails);
  EXPECT_FALSE(blind.respond(1.1, {})->fails);
}

TEST(StrengthReductionTest, CutsOnlyTheMaterialsThatTheLastStageNames) {
  Scene scene = coarse_slope();
  scene.materials.push_back(scene.materials.front());
  scene.materials.back().name = "rock";
  for (Body& body : scene.bodies) body.material = "clay";
  scene.stages.back().material_strength_reduction = {{"clay", 1.0}};
  scene.stages.back().strength_reduction = 0.9;
  const StrengthReduction slope = settled_slope(scene);
  const Scene cut = slope.reduced(2.0, 1.0).scene();
  const Stage& last = cut.stages.back();
  EXPECT_EQ(last.strength_reduction, 0.9);
  EXPECT_EQ(last.material_strength_reduction.at("clay"), 2.0);
  // The way leads from the settled strength there by a tenth of 1.5 each time, logarithmically.
  const double ratio = std::pow(1.5, 0.1);
  const Stage& first = cut.stages.at(1);
  EXPECT_NEAR(first.material_strength_reduction.at("clay"), ratio, 1e-12);
  EXPECT_NEAR(first.strength_reduction, 1.0 / ratio, 1e-12);
  EXPECT_EQ(cut.stages.at(3).strength_reduction, 0.9);
  EXPECT_EQ(cut.stages.size(), 1U + 18U);  // ln 2/ln ratio = 17.1
}

TEST(CutTest, CutsShareTheirWayAsFarAsTheSmallerGoes) {
  const StageStrength settled{0.8, {{"rock", 0.5}}};
  const auto small = cut_levels(settled, {1.1}), large = cut_levels(settled, {1.6});
  ASSERT_LT(small.size(), large.size());
  EXPECT_TRUE(std::equal(small.begin(), small.end(), large.begin()));
  EXPECT_EQ(cut_levels({}, {1.5}).size(), 9U);
  EXPECT_TRUE(cut_levels(settled, {0.8}).empty());
  EXPECT_LT(small.back().all, 1.1);
  // What a material has of its own it is cut from.
  EXPECT_NEAR(cut_levels(settled, {1.0, {{"rock", 1.0}}}).front().materials.at("rock"),
              0.5 * std::pow(1.5, 0.1), 1e-12);
}

/// Bit for bit, whatever was tried before it and kept on the way.
TEST(StrengthReductionTest, ATrialDependsOnItsFactorAlone) {
  StrengthReduction one = settled_slope(coarse_slope()), other = settled_slope(coarse_slope());
  ASSERT_TRUE(one.measure_elastic({}));
  ASSERT_TRUE(other.measure_elastic({}));
  ASSERT_TRUE(one.respond(1.55, {})->fails);
  ASSERT_FALSE(one.respond(1.2, {})->fails);
  for (const double reduction : {1.3, 1.45}) {
    const std::optional<Trial> late = one.respond(reduction, {});
    const std::optional<Trial> first = other.respond(reduction, {});
    EXPECT_EQ(late->fails, first->fails);
    EXPECT_EQ(late->displacement, first->displacement);
    EXPECT_EQ(late->speed, first->speed);
    EXPECT_EQ(late->time, first->time);
    EXPECT_LE(late->steps, first->steps);
  }
  EXPECT_LT(one.respond(1.45, {})->steps, settled_slope(coarse_slope()).respond(1.45, {})->steps);
}

/// The search by few trials finds the bracket that halving with whole trials finds.
TEST(StrengthReductionTest, TheFactorIsThatOfHalvingWithWholeTrials) {
  StrengthReduction slope = settled_slope(coarse_slope());
  const FactorOfSafety found = find_factor(slope, {1.2, 1.6, 0.02}, {});
  ASSERT_TRUE(found.bracket.complete);
  Criterion whole = slope.criterion();
  whole.early_stop = false;
  StrengthReduction same(slope.settled().clone(), whole);
  const Bracket halved =
      find_limit({1.2, 1.6, 0.02}, [&](double reduction) -> std::optional<Outcome> {
        return Outcome{reduction, same.respond(reduction, {})->fails};
      });
  ASSERT_TRUE(halved.complete);
  EXPECT_LT(*found.bracket.stands, *halved.fails);
  EXPECT_LT(*halved.stands, *found.bracket.fails);
  EXPECT_LE(found.trials.size(), 6U);  // halving takes 2 + 4
}

/// What a search has found, and the steps that it was told of, from which threads.
struct Heard {
  std::uint64_t steps = 0;
  bool from_elsewhere = false;
  FactorOfSafety found;
};
Heard search_with_threads(int threads, std::uint64_t most_steps) {
  RunOptions options;
  options.threads = threads;
  options.oversubscribe = true;
  Simulation simulation(coarse_slope(), options);
  EXPECT_TRUE(settle(simulation, {}));
  StrengthReduction slope(std::move(simulation), choose_criterion(coarse_slope(), {}));
  Heard heard;
  const std::thread::id here = std::this_thread::get_id();
  heard.found = find_factor(slope, {1.2, 1.6, 0.02}, [&](const Simulation&) {
    heard.from_elsewhere = heard.from_elsewhere || std::this_thread::get_id() != here;
    return ++heard.steps < most_steps;
  });
  return heard;
}

/// The slope is a single chunk of particles, so three trials share three threads. What runs ahead
/// is not heard of until it is waited for, and then from its own thread.
TEST(StrengthReductionTest, TrialsSideBySideAreThoseOneByOne) {
  constexpr std::uint64_t all = 1000000;
  const Heard alone = search_with_threads(1, all), beside = search_with_threads(3, all);
  ASSERT_EQ(alone.found.trials.size(), beside.found.trials.size());
  for (std::size_t k = 0; k < alone.found.trials.size(); ++k) {
    const Trial &one = alone.found.trials[k], &two = beside.found.trials[k];
    EXPECT_EQ(one.reduction, two.reduction);
    EXPECT_EQ(one.fails, two.fails);
    EXPECT_EQ(one.displacement, two.displacement);
    EXPECT_EQ(one.speed, two.speed);
    EXPECT_EQ(one.time, two.time);
  }
  EXPECT_TRUE(beside.found.bracket.complete);
  EXPECT_FALSE(alone.from_elsewhere);
  EXPECT_TRUE(beside.from_elsewhere || beside.steps < alone.steps) << "none ran ahead";
}

TEST(StrengthReductionTest, ATrialThatRunsAheadStopsWithTheSearch) {
  const std::uint64_t elastic = search_with_threads(1, 1000000).found.elastic.steps;
  const Heard stopped = search_with_threads(3, elastic + 10);
  EXPECT_EQ(stopped.found.trials.size(), 0U);
  EXPECT_EQ(stopped.steps, elastic + 10);
}

/// It fails long before the strength is down there.
TEST(StrengthReductionTest, ASlopeThatFailsOnTheWayIsATrialOfTheFactorReached) {
  StrengthReduction slope = settled_slope(coarse_slope());
  ASSERT_TRUE(slope.measure_elastic({}));
  const std::optional<Trial> far = slope.respond(5.0, {});
  ASSERT_TRUE(far->fails);
  EXPECT_GT(far->reduction, 1.37);
  EXPECT_LT(far->reduction, 2.5);
  EXPECT_LT(far->time, slope.criterion().ramp * std::log(far->reduction) / std::log(1.5) * 1.3);
  StrengthReduction same = settled_slope(coarse_slope());
  ASSERT_TRUE(same.measure_elastic({}));
  const std::optional<Trial> near = same.respond(far->reduction, {});
  EXPECT_EQ(near->reduction, far->reduction);
  EXPECT_EQ(near->displacement, far->displacement);
  EXPECT_EQ(near->time, far->time);
}

TEST(StrengthReductionTest, ASlopeThatFailsUnreducedIsRefused) {
  Scene weak = coarse_slope();
  weak.materials.front().model.set("cohesion", 1e3);
  weak.materials.front().model.set("friction_angle", 0.1);
  weak.materials.front().model.set("dilation_angle", 0.0);
  weak.stages.front().duration = 0.1;
  StrengthReduction slope = settled_slope(weak);
  EXPECT_NE(message_of([&] { find_factor(slope, {}, {}); }).find("strength_reduction below 1"),
            std::string::npos);
  EXPECT_FALSE(slope.elastic());
}

TEST(SettleStandingTest, ASlopeBelowItsLimitIsStrengthenedAndItsFactorFound) {
  Scene weak = coarse_slope();
  SoilModel& soil = weak.materials.front().model;
  soil.set("cohesion", soil.parameter("cohesion") / 1.6);
  soil.set("friction_angle", std::atan(std::tan(soil.parameter("friction_angle")) / 1.6));
  const Criterion criterion = choose_criterion(weak, {});
  std::vector<double> told;
  std::optional<StandingSlope> standing =
      settle_standing(weak, {}, criterion, {}, [&](double more) { told.push_back(more); });
  ASSERT_TRUE(standing);
  EXPECT_EQ(standing->strengthening, 2.0);
  EXPECT_EQ(told, std::vector<double>{2.0});
  EXPECT_EQ(standing->slope.settled().scene().stages.front().strength_reduction, 0.5);
  EXPECT_EQ(standing->slope.settled().scene().stages.back().strength_reduction, 1.4);
  const FactorOfSafety found = find_factor(standing->slope, {0.8, 1.0, 0.1}, {});
  ASSERT_TRUE(found.bracket.complete);
  // Bishop's factor scales with c and tan phi together: 1.377/1.6; coarse as the slope above.
  EXPECT_NEAR(*found.bracket.factor(), 1.377 / 1.6, 0.1377 / 1.6);
}

/// Oblique gravity from end to end: geostatic start, height, factor.
TEST(SettleStandingTest, ATiltedFlumeHasTheFactorOfTheInfiniteSlope) {
  const double tilt = 0.35, c = 1e3, phi = 0.5236, depth = 1.0;
  const auto factor_of = [&](double length) {
    Scene scene = coarse_slope();
    scene.spacing = 0.2;
    scene.gravity = {9.81 * std::sin(tilt), -9.81 * std::cos(tilt), 0.0};
    scene.materials = {{"sand", DruckerPrager{50e6, 0.3, c, phi, phi, Cone::plane_strain}, 2000.0}};
    scene.bodies = {{.shape = Box{{0, 0, 0}, {length, depth, 0}}}};
    scene.walls = {
        test::wall_of("base", WallKind::no_slip, {test::facet_2d(0, 0, length, 0)}),
        test::wall_of("ends", WallKind::free_slip,
                      {test::facet_2d(length, 0, length, 3), test::facet_2d(0, 3, 0, 0)})};
    scene.probes.front().at = {0.5 * length, depth, 0};
    const Criterion criterion = choose_criterion(scene, {});
    EXPECT_NEAR(criterion.height, length * std::sin(tilt), scene.spacing);
    std::optional<StandingSlope> standing = settle_standing(scene, {}, criterion, {});
    EXPECT_TRUE(standing);
    EXPECT_EQ(standing->strengthening, 1.0);
    const FactorOfSafety found = find_factor(standing->slope, {1.6, 2.0, 0.02}, {});
    EXPECT_TRUE(found.bracket.complete);
    return *found.bracket.factor();
  };
  // The soil leans on the lower end, which adds a share that falls with the length.
  const double at_10 = factor_of(10.0), at_20 = factor_of(20.0), endless = 2.0 * at_20 - at_10;
  EXPECT_GT(at_10, at_20 + 0.05);
  // (c + gamma d cos(tilt) tan(phi))/(gamma d sin(tilt)): 1.730. Brackets 0.02 wide leave 0.03,
  // five rows 2 per cent.
  const double gamma = 2000.0 * 9.81 * depth;
  const double expected = (c + gamma * std::cos(tilt) * std::tan(phi)) / (gamma * std::sin(tilt));
  EXPECT_NEAR(endless, expected, 0.04 * expected);
}

TEST(SettleStandingTest, ASlopeThatStandsIsTakenAsItIs) {
  const Scene scene = coarse_slope();
  std::optional<StandingSlope> standing =
      settle_standing(scene, {}, choose_criterion(scene, {}), {}, [](double) { FAIL(); });
  ASSERT_TRUE(standing);
  EXPECT_EQ(standing->strengthening, 1.0);
  ASSERT_TRUE(standing->slope.elastic());
  EXPECT_FALSE(settle_standing(scene, {}, choose_criterion(scene, {}),
                               [](const Simulation&) { return false; }));
}

TEST(StrengthReductionTest, StopsWhenAsked) {
  Simulation simulation(coarse_slope());
  EXPECT_FALSE(settle(simulation, [](const Simulation&) { return false; }));
  StrengthReduction slope = settled_slope(coarse_slope());
  int left = 2;  // the elastic response and one trial
  bool stop = false;
  const FactorOfSafety found = find_factor(
      slope, {1.2, 1.6, 0.01}, [&](const Simulation&) { return !stop; },
      [&](const FactorOfSafety&, const Trial&) { stop = --left == 0; });
  EXPECT_EQ(found.trials.size(), 1U);
  EXPECT_FALSE(found.bracket.complete);
  EXPECT_EQ(found.bracket.stands, 1.2);
}

}  // namespace
}  // namespace scarp
