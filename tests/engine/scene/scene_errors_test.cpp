// SPDX-License-Identifier: BSD-3-Clause
/// Scenes that must be refused: each names its line and what is wrong, whatever the bytes.
#include <gtest/gtest.h>

#include <sys/resource.h>

#include <random>

#include "engine/errors.hpp"
#include "engine/scene/scene_reader.hpp"
#include "engine/simulation.hpp"
#include "tests/engine/scene/bad_scenes.hpp"
#include "tests/engine/scene/scene_texts.hpp"
#include "tests/support/scene_message.hpp"

namespace scarp {
namespace {

TEST(SceneErrorsTest, EachBadSceneIsNamedByFileLineKeyValueReasonAndAdvice) {
  static_assert(std::size(bad_scenes) >= 80);
  for (const BadScene& bad : bad_scenes) {
    const std::string text = replaced(bad.three_d ? everything_text : slope_text, bad.from, bad.to);
    try {
      read_scene_text(text, "bad.toml");
      ADD_FAILURE() << "accepted: " << bad.to;
    } catch (const SceneError& error) {
      const std::string what = error.what(), at = "bad.toml:" + std::to_string(bad.line) + ": ";
      EXPECT_EQ(what.find(at), 0u) << "wanted line " << bad.line << ": " << what;
      EXPECT_NE(what.find(bad.words), std::string::npos) << "wanted " << bad.words << ": " << what;
      EXPECT_NE(what.find("Try ") == std::string::npos,
                what.find("Did you mean") == std::string::npos)
          << "no single advice: " << what;
      EXPECT_EQ(fault_of_message(what, "bad.toml"), "") << what;
      if (!bad.has_key) continue;
      EXPECT_EQ(what.find("key '"), at.size()) << "no key: " << what;
      const bool missing = what.find("' is missing. ") != std::string::npos;
      EXPECT_NE(what.find("' = ") != std::string::npos, missing) << "no value: " << what;
    }
  }
}

/// The most memory the process has ever used [bytes].
double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

TEST(SceneErrorsTest, WhatCannotFitIntoMemoryIsRefusedWithTheNumbersBeforeItIsTaken) {
  const struct {
    const std::string& scene;
    const char *from, *to, *words;
  } rows[] = {
      {slope_text, "\"0.25 m\"", "1e-6",
       "bad.toml:18: key 'body[0]' = polygon from (0, 0) to (45, 15): "},
      {slope_text, "\"0.25 m\"", "1e-9", "bad.toml:18: key 'body[0]' = "},
      {slope_text, "[45, 0]]", "[1e9, 0]]", "bad.toml:22: key 'wall[0]' = 'base': "},
      {everything_text, "spacing = 0.1", "spacing = 1e-4",
       "bad.toml:39: key 'body[0]' = polygon from "},
  };
  const double before = peak_memory();
  for (const auto& row : rows) {
    try {
      Simulation simulation(read_scene_text(replaced(row.scene, row.from, row.to), "bad.toml"));
      ADD_FAILURE() << "accepted: " << row.to;
    } catch (const SceneError& error) {
      const std::string what = error.what();
      EXPECT_EQ(fault_of_message(what, "bad.toml"), "") << what;
      EXPECT_NE(what.find(row.words), std::string::npos) << what;
      EXPECT_NE(what.find("particles at spacing"), std::string::npos) << what;
      EXPECT_NE(what.find(" GB of memory"), std::string::npos) << what;
    }
  }
  // The soil of one of them, 6,000 particles, is placed before its wall is counted.
  EXPECT_LT(peak_memory() - before, 64e6);
}

TEST(SceneErrorsTest, EmptySectionsAreNamed) {
  for (const char* section : {"material", "body", "stage"}) {
    std::string text = "dimension = 2\nspacing = 1\n";
    if (section != std::string("material")) {
      text +=
          "[[material]]\nname = \"a\"\nmodel = \"linear_elastic\"\ndensity = 1\n"
          "youngs_modulus = 1\npoisson_ratio = 0\n";
    }
    if (section == std::string("stage")) {
      text += "[[body]]\nmaterial = \"a\"\nbox = {min = [0, 0], max = [1, 1]}\n";
    }
    try {
      read_scene_text(text, "bad.toml");
      ADD_FAILURE() << "accepted without " << section;
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find(std::string("bad.toml:1: key '") + section + "'"),
                std::string::npos)
          << error.what();
    }
  }
}

/// Reads bytes that may or may not be a scene; anything but success or SceneError fails the test.
void survive(const std::string& text) {
  try {
    read_scene_text(text, "bytes");
  } catch (const SceneError& error) {
    EXPECT_EQ(fault_of_message(error.what(), "bytes"), "") << error.what();
  }
}

TEST(SceneErrorsTest, GarbageEndsInSceneError) {
  const std::string zero(1, '\0');
  const std::string garbage[] = {
      "[[\n",
      "[[=",
      "[[[",
      "[",
      "]",
      "=",
      "\"",
      "'''",
      "\"\"\"",
      "\"\\",
      "\xEF\xBB\xBF",
      "\xEF\xBB",
      "dp\xC6\xAC = 1",
      "\xC6\xAC",
      "\xFF\xFE",
      zero,
      "a = \"" + zero + "\"",
      "a.b.c.d = {}",
      "a = \"\xFF\"",
      "# \xFF",
      "dimension = 2\r",
      std::string(400, '['),
      "a = " + std::string(400, '['),
      "a = " + std::string(100000, '['),
      "material = [[]]",
      "material = [1]",
      "material = [{}]",
      "[material]\n[[material]]",
      "stage.stage = 1",
      "[[body]]\n[[body.box]]",
      "dimension = 2\nspacing = 1\nnumerics = []",
      "dimension = 2\nspacing = 1\nwall = {}",
      "dimension = 2\nspacing = 1\nstage = [{name = 'a', strength_reduction = {a = {}}}]",
      "dimension = 2\nspacing = 1\n[[material]]\nmodel = 3",
      std::string(100000, 'a') + " = 1",
      "\"a\\u0000\\n\" = 1",
      replaced(slope_text, "reduction = 1.4", "reduction = {\"a.\\u0000b\" = 1.4}"),
      "dimension = 1e400",
      "spacing = 0x",
      "dimension = 2\nspacing = 2024-13-45"};
  for (const std::string& text : garbage) {
    EXPECT_THROW(read_scene_text(text, "bytes"), SceneError) << text.substr(0, 40);
    survive(text);
  }
}

/// Repeats of one or more texts.
std::string times(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t k = 0; k < count; ++k) all += text;
  return all;
}

/// `text` for each number below `count`, which stands where it has a #.
std::string numbered(int count, const std::string& text) {
  std::string all;
  for (int k = 0; k < count; ++k) all += replaced(text, "#", std::to_string(k));
  return all;
}

TEST(SceneErrorsTest, NothingIsTooDeepOrTooMuchForTheParser) {
  // Each of these ended the program or took minutes: the parser calls itself for every part of a
  // name and for every bracket, and searches all dotted names at each of them.
  constexpr std::size_t deep = 200'000;
  const std::string dotted = times(deep, "a.") + "b", quoted = times(deep, "\"a\" . ") + "'b'";
  const std::pair<std::string, const char*> rows[] = {
      {dotted + " = 1", "parts"},
      {"[" + dotted + "]", "parts"},
      {"[[" + dotted + "]]", "parts"},
      {quoted + " = 1", "parts"},
      {"[" + quoted + "]", "parts"},
      {"a = {" + dotted + " = 1}", "parts"},
      {"a = [1, {" + dotted + " = 1}]", "parts"},
      {"a = " + times(deep, "{a = ") + "1" + times(deep, "}"), "brackets"},
      {"a = " + times(deep, "["), "brackets"},
      {"a = " + times(deep, "[{b = "), "brackets"},
      {times(16, "[[a.a.a.a.a.a]]\na.a.a.a.a.a.a.a = {b.b.b = [[[{c.c.c = 1}]]]}\n"), ""},
      {numbered(400'000, "a#.b = 1\n") + numbered(400'000, "a#.c = 1\n"), "dots"},
      {numbered(400'000, "[a#.b]\n") + numbered(400'000, "[a#]\n"), "dots"},
      {times(800'000, "[[a]]\n"), "values"},
      {"a = [" + times(4'000'000, "1,") + "]", "values"},
      {"a = [" + times(4'000'000, "{},") + "]", "values"},
      {"title = \"" + times(1001, "x") + "\"", "1001 letters"},
      {"title = '" + times(std::size_t{17} << 20, "x") + "'", "16 MiB"},
      {"dimension = 2\nspacing = 1\n" + times(10'001, "[[probe]]\nname = 'a'\nat = [0, 0]\n"),
       "10001, more than 10000"},
      {"dimension = 2\nspacing = 1\n" + times(1001, "[[material]]\nname = 'a'\n"),
       "1001, more than 1000"},
  };
  for (const auto& [text, words] : rows) {
    try {
      read_scene_text(text, "bytes");
      ADD_FAILURE() << "accepted: " << text.substr(0, 60);
    } catch (const SceneError& error) {
      EXPECT_EQ(fault_of_message(error.what(), "bytes"), "") << error.what();
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }
}

TEST(SceneErrorsTest, WhatLooksDeepInsideTextAndCommentsIsNot) {
  const std::string deep = times(60, "[{a.") + times(60, "]}");
  for (const std::string& quote :
       {std::string("\""), std::string("'"), std::string("\"\"\""), std::string("\'\'\'")}) {
    const std::string title = replaced(slope_text, "\"Cohesive slope\"", quote + deep + quote);
    EXPECT_EQ(read_scene_text(title, "bytes").title, deep) << quote;
  }
  EXPECT_NO_THROW(read_scene_text(replaced(slope_text, "2000.0", "2000.0  # " + deep), "bytes"));
  // A quote that is escaped, a line end that is, and quotes that end a text of several lines.
  const std::string text = "\"\"\"a \\\"\"\" " + deep + "\\\n'" + deep + "\"\"\"\"\"";
  EXPECT_EQ(read_scene_text(replaced(slope_text, "\"Cohesive slope\"", text), "bytes").title,
            "a \"\"\" " + deep + "'" + deep + "\"\"");
}

TEST(SceneErrorsTest, ScenesCutOrSpoiltAnywhereNeverCrash) {
  for (const std::string* text : {&slope_text, &everything_text}) {
    for (std::size_t length = 0; length < text->size(); ++length) survive(text->substr(0, length));
    std::mt19937 random(1);
    const std::string likely = "[]{}=\"'.,#\n\\ 0-ex\xC3\xFF";
    for (int i = 0; i < 4000; ++i) {
      std::string spoilt = *text;
      for (int k = 0; k < 1 + i % 3; ++k) {
        spoilt[random() % spoilt.size()] = likely[random() % likely.size()];
      }
      survive(spoilt);
    }
  }
}

}  // namespace
}  // namespace scarp
