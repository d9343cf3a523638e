// SPDX-License-Identifier: BSD-3-Clause
/// Outlines that cross themselves, and those that only touch.
#include "engine/scene/outline.hpp"

#include <gtest/gtest.h>

#include "engine/errors.hpp"
#include "engine/scene/scene_reader.hpp"
#include "tests/engine/scene/scene_texts.hpp"

namespace scarp {
namespace {

TEST(OutlineTest, CrossingsAreFoundWithTheirEdgesAndPoint) {
  const auto bow = self_crossing({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  ASSERT_TRUE(bow);
  EXPECT_EQ(bow->first, 0u);
  EXPECT_EQ(bow->second, 2u);
  EXPECT_DOUBLE_EQ(bow->at[0], 1.0);
  EXPECT_DOUBLE_EQ(bow->at[1], 1.0);
  // Far from the origin, and where the crossing edges are the first and the last but one.
  EXPECT_TRUE(self_crossing({{1e6, 0}, {1e6 + 2, 2}, {1e6 + 2, 0}, {1e6, 2}}));
  EXPECT_TRUE(self_crossing({{0, 0}, {10, 0}, {10, 10}, {5, -1e-3}, {0, 10}}));
}

TEST(OutlineTest, OutlinesThatOnlyTouchDoNotCross) {
  EXPECT_FALSE(self_crossing({{0, 0}, {45, 0}, {45, 5}, {32, 5}, {12, 15}, {0, 15}}));
  // A hole joined by a cut; a point on an edge; two squares that share a corner; a needle.
  EXPECT_FALSE(self_crossing(
      {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 1}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {0, 1}}));
  EXPECT_FALSE(self_crossing({{0, 0}, {10, 0}, {10, 10}, {5, 0}, {0, 10}}));
  EXPECT_FALSE(self_crossing({{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}));
  EXPECT_FALSE(self_crossing({{0.1, 0.1}, {0.7, 0.7}, {0.3, 0.3}, {0, 1}}));
}

TEST(OutlineTest, ASceneWithACrossingIsRefusedWithThePoint) {
  std::string text = slope_text;
  const std::string good = "[45, 5], [32, 5], [12, 15]", bad = "[12, 15], [32, 5], [45, 5]";
  ASSERT_NE(text.find(good), std::string::npos);
  text.replace(text.find(good), good.size(), bad);
  try {
    read_scene_text(text, "slope.toml");
    FAIL() << "accepted";
  } catch (const SceneError& error) {
    const std::string what = error.what();
    EXPECT_EQ(what.find("slope.toml:"), 0u) << what;
    EXPECT_NE(what.find("key 'body[0].polygon' = "), std::string::npos) << what;
    EXPECT_NE(what.find("the edges from [45, 0] to [12, 15] and from ["), std::string::npos)
        << what;
  }
}

}  // namespace
}  // namespace scarp
