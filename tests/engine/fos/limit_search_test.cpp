// SPDX-License-Identifier: BSD-3-Clause
/// The search for the limit, on responses that are known.
#include "engine/fos/limit_search.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace scarp {
namespace {

/// Fails above `limit`; remembers what it was asked.
struct Response {
  double limit;
  std::vector<double> asked;
  std::optional<bool> operator()(double reduction) {
    asked.push_back(reduction);
    return reduction > limit;
  }
};

Bracket search(Response& response, const SearchOptions& options) {
  return find_limit(options, [&](double reduction) { return response(reduction); });
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

TEST(LimitSearch, StopsWhenToldAndKeepsTheBracketSoFar) {
  int asked = 0;
  const Bracket bracket = find_limit({}, [&](double reduction) -> std::optional<bool> {
    if (++asked > 3) return {};
    return reduction > 1.377;
  });
  EXPECT_EQ(asked, 4);
  EXPECT_FALSE(bracket.complete);
  EXPECT_EQ(bracket.stands, 1.25);
  EXPECT_EQ(bracket.fails, 1.5);
}

}  // namespace
}  // namespace scarp
