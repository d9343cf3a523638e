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
       "bad.toml:41: key 'body[0]' = polygon from "},
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
