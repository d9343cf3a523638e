// SPDX-License-Identifier: BSD-3-Clause
/// The search for the limit, on responses that are known.
#include "engine/fos/limit_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace scarp {
namespace {

/// Fails above `limit`; remembers what it was asked.
struct Response {
  double limit;
  std::vector<double> asked;
  double told = 0.0;  ///< of the true excess, as trials tell it; 0: nothing
  double bent = 1.0;  ///< its power of the true excess
  Outcome operator()(double reduction) {
    asked.push_back(reduction);
    const bool fails = reduction > limit;
    return {reduction, fails, fails ? told * std::pow(reduction / limit - 1.0, bent) : 0.0};
  }
};

Bracket search(Response& response, const SearchOptions& options) {
  return find_limit(
      options, [&](double reduction) -> std::optional<Outcome> { return response(reduction); });
}

TEST(LimitSearch, EnclosesTheLimitWhereverItStarts) {
  for (const double limit : {0.05, 0.7, 0.999, 1.0, 1.377, 2.4, 17.0}) {
    for (const SearchOptions& options :
         {SearchOptions{}, SearchOptions{0.5, {}, 0.01}, SearchOptions{3.0, {}, 0.001},
          SearchOptions{1.2, 1.6, 0.02}}) {
      Response response{limit, {}};
      const Bracket bracket = search(response, options);
      ASSERT_TRUE(bracket.complete) << limit;
      EXPECT_LE(*bracket.stands, limit);
      EXPECT_GT(*bracket.fails, limit);
      EXPECT_LE(*bracket.fails - *bracket.stands, options.tolerance * *bracket.factor());
      EXPECT_DOUBLE_EQ(*bracket.factor(), 0.5 * (*bracket.stands + *bracket.fails));
    }
  }
}

TEST(LimitSearch, TakesTheGivenBracketFirstAndAsksNothingTwice) {
  Response response{1.377, {}};
  search(response, {1.2, 1.6, 0.02});
  ASSERT_GE(response.asked.size(), 4U);
  EXPECT_EQ(response.asked[0], 1.2);
  EXPECT_EQ(response.asked[1], 1.6);
  EXPECT_DOUBLE_EQ(response.asked[2], 1.4);
  EXPECT_DOUBLE_EQ(response.asked[3], 1.3);
  // 0.4 wide, halved to 0.02 of 1.38: four halvings.
  EXPECT_EQ(response.asked.size(), 2U + 4U);
}

TEST(LimitSearch, StepsOutwardFromAGivenEndThatStands) {
  Response response{2.0, {}};
  const Bracket bracket = search(response, {1.2, 1.6, 0.02});
  EXPECT_TRUE(bracket.complete);
  EXPECT_DOUBLE_EQ(response.asked[2], 1.6 * 1.5);
}

TEST(LimitSearch, SaysWhatItKnowsWhereThereIsNoLimit) {
  Response strong{1e9, {}};
  const Bracket stands = search(strong, {});
  EXPECT_EQ(stands.stands, most_reduction);
  EXPECT_FALSE(stands.fails);
  EXPECT_FALSE(stands.factor());
  EXPECT_FALSE(stands.complete);
  Response weak{0.0, {}};
  const Bracket fails = search(weak, {});
  EXPECT_EQ(fails.fails, least_reduction);
  EXPECT_FALSE(fails.stands);
  EXPECT_FALSE(fails.complete);
}

/// Trials of slopes are off by up to a sixth. Halving takes six or seven after the outward steps.
TEST(LimitSearch, TakesFewTrialsWhereFailuresTellHowFarTheyAre) {
  for (const double limit : {0.7, 1.05, 1.377, 1.49, 2.28}) {
    for (const double told : {0.85, 1.0, 1.15}) {
      Response response{limit, {}, told};
      const SearchOptions options;
      const Bracket bracket = search(response, options);
      ASSERT_TRUE(bracket.complete) << limit;
      EXPECT_LE(*bracket.stands, limit);
      EXPECT_GT(*bracket.fails, limit);
      const std::size_t outward = limit < 1.0 ? 2 : limit < 1.5 ? 2 : 4;
      EXPECT_LE(response.asked.size(), outward + (told == 1.0 ? 2 : 5))
          << limit << " told " << told;
    }
  }
}

TEST(LimitSearch, IsNotLedAstrayByFailuresThatTellNonsense) {
  for (const double told : {1e-6, 0.1, 10.0, 1e6}) {
    for (const double bent : {0.2, 1.0, 4.0}) {
      Response response{1.377, {}, told, bent};
      const Bracket bracket = search(response, {});
      ASSERT_TRUE(bracket.complete);
      EXPECT_LE(*bracket.stands, 1.377);
      EXPECT_GT(*bracket.fails, 1.377);
      EXPECT_LE(response.asked.size(), 2U + 3U * 6U);  // six halvings, three trials each at worst
    }
  }
}

TEST(LimitSearch, GoesOnFromAnyTrialAsIfItHadNotStopped) {
  Response whole{1.377, {}, 0.8};
  const Bracket bracket = search(whole, {});
  for (std::size_t count = 0; count <= whole.asked.size(); ++count) {
    Response same{1.377, {}, 0.8};
    std::vector<Outcome> known;
    for (std::size_t k = 0; k < count; ++k) known.push_back(same(whole.asked[k]));
    const Bracket resumed = find_limit(
        {}, [&](double r) -> std::optional<Outcome> { return same(r); }, known);
    EXPECT_EQ(same.asked, whole.asked);
    EXPECT_EQ(resumed.factor(), bracket.factor());
  }
}

/// Where failures tell the truth, what is likely comes next; if a trial does the other, what was
/// second. Nothing is said where nothing is known.
TEST(LimitSearch, TellsWhatMayComeNext) {
  const SearchOptions options;
  EXPECT_EQ(likely_next(options, {}, 1.0), (std::vector{1.5, 1.0 / 1.5}));
  EXPECT_TRUE(likely_next(options, {{1.0}}, 1.5).empty());
  EXPECT_TRUE(likely_next(options, {{1.0}, {1.5, true}}, 1.25).empty()) << "1.5 has told nothing";
  // At 1.5 the first is told exactly, the second as if it were 0.8 % lower: the next one stands.
  for (const double told : {1.0, 1.1}) {
    const std::size_t place = told == 1.0 ? 0 : 1;
    Response response{1.377, {}, told};
    std::vector<Outcome> outcomes{response(1.0), response(1.5)};
    std::size_t asked = 0;
    while (const std::optional<double> next = next_factor(options, outcomes)) {
      const std::vector<double> likely = likely_next(options, outcomes, *next);
      outcomes.push_back(response(*next));
      const std::optional<double> then = next_factor(options, outcomes);
      if (!then) break;
      ++asked;
      ASSERT_GT(likely.size(), place);
      EXPECT_EQ(likely[place], *then) << told;
    }
    EXPECT_EQ(asked, 1U) << told;
  }
}

TEST(LimitSearch, StopsWhenToldAndKeepsTheBracketSoFar) {
  int asked = 0;
  const Bracket bracket = find_limit({}, [&](double reduction) -> std::optional<Outcome> {
    if (++asked > 3) return {};
    return Outcome{reduction, reduction > 1.377};
  });
  EXPECT_EQ(asked, 4);
  EXPECT_FALSE(bracket.complete);
  EXPECT_EQ(bracket.stands, 1.25);
  EXPECT_EQ(bracket.fails, 1.5);
}

}  // namespace
}  // namespace scarp
