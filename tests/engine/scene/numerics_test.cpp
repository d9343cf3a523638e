// SPDX-License-Identifier: BSD-3-Clause
/// The table of numerics against what a scene, the presets and SCENE.md say.
#include "engine/scene/numerics_list.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "engine/scene/scene_reader.hpp"
#include "tests/engine/scene/scene_texts.hpp"

namespace scarp {
namespace {

using Kind = NumericsRow::Kind;

std::string quoted(std::string words) {
  for (std::size_t bar; (bar = words.find('|')) != std::string::npos;)
    words.replace(bar, 1, "\"`, `\"");
  return "`\"" + words + "\"`";
}

std::string type_of(const NumericsRow& row) {
  if (row.kind == Kind::truth) return "bool";
  if (row.kind == Kind::choice) return quoted(std::string(row.words));
  const std::string type = row.kind == Kind::integer ? "integer" : "number";
  return row.words.empty() ? type : type + " or " + quoted(std::string(row.words));
}

std::string value_of(const NumericsRow& row, const Numerics& numerics) {
  const std::string written = row.written(numerics);
  const bool word = row.kind == Kind::choice || written == row.words;
  return word ? quoted(written) : written;
}

/// The line of SCENE.md that a row stands for.
std::string line_of(const NumericsRow& row) {
  const bool bounded = row.kind == Kind::number || row.kind == Kind::integer;
  return fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |", row.key, type_of(row),
                     value_of(row, preset("modern")), value_of(row, preset("paper")), row.unit,
                     bounded ? fmt::format("{:g} to {:g}", row.minimum, row.maximum) : "",
                     row.text);
}

TEST(NumericsTest, ThePageShowsTheTable) {
  std::ifstream page(std::filesystem::path(SCARP_SOURCE_DIR) / "engine/scene/SCENE.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  std::string table;
  for (const NumericsRow& row : numerics_list) table += line_of(row) + "\n";
  EXPECT_NE(text.find("\n" + table + "\n"), std::string::npos)
      << "SCENE.md should have these lines and no others under [numerics]:\n"
      << table;
}

/// Another value than `now` that the row allows.
double other(const NumericsRow& row, double now) {
  if (row.kind == Kind::truth || row.kind == Kind::choice) return now == 0.0 ? 1.0 : 0.0;
  if (row.kind == Kind::integer) return now + 1.0;
  return now == 0.0 ? 0.5 * row.maximum : std::fmin(1.1 * now, row.maximum);
}

TEST(NumericsTest, EachRowSetsOneMemberOfItsOwn) {
  for (const NumericsRow& row : numerics_list) {
    Numerics changed = preset("modern");
    row.set(changed, other(row, row.get(changed)));
    for (const NumericsRow& each : numerics_list) {
      EXPECT_EQ(each.get(changed) == each.get(preset("modern")), each.key != row.key)
          << row.key << " and " << each.key;
    }
  }
}

TEST(NumericsTest, AKeyOfASceneReplacesItsRowOfThePreset) {
  for (const char* name : {"modern", "paper"}) {
    for (const NumericsRow& row : numerics_list) {
      Numerics wanted = preset(name);
      row.set(wanted, other(row, row.get(wanted)));
      std::string value = row.written(wanted);
      if (row.kind == Kind::choice || value == row.words) value = '"' + value + '"';
      std::string text = slope_text;
      const std::string key = "preset = \"modern\"";
      text.replace(text.find(key), key.size(),
                   fmt::format("preset = \"{}\"\n[numerics]\n{} = {}", name, row.key, value));
      const Scene scene = read_scene_text(text, "test.toml", {});
      for (const NumericsRow& each : numerics_list)
        EXPECT_EQ(each.get(scene.numerics), each.get(wanted)) << row.key << " and " << each.key;
    }
  }
}

TEST(NumericsTest, BoundsHoldAndOneStepBeyondIsRefusedByName) {
  for (const NumericsRow& row : numerics_list) {
    if (row.kind == Kind::truth) continue;
    for (const bool above : {false, true}) {
      Scene scene = read_scene_text(slope_text, "test.toml", {});
      const double bound = above ? row.maximum : row.minimum;
      const double next = std::nextafter(bound, above ? 1e300 : -1e300);
      row.set(scene.numerics, row.kind == Kind::number ? next : bound + (above ? 1.0 : -1.0));
      try {
        validate(scene);
        ADD_FAILURE() << row.key << " beyond " << bound << " is let pass";
      } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find(fmt::format("numerics.{}", row.key)),
                  std::string::npos)
            << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace scarp
