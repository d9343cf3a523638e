// SPDX-License-Identifier: BSD-3-Clause
/// Warnings about numbers that soils do not have, and weights in place of densities.
#include <gtest/gtest.h>

#include "engine/check/warnings.hpp"
#include "engine/errors.hpp"
#include "engine/scene/scene_reader.hpp"
#include "tests/engine/scene/scene_texts.hpp"

namespace scarp {
namespace {

Scene with(const std::string& from, const std::string& to) {
  return read_scene_text(replaced(slope_text, from, to), "slope.toml");
}

struct Odd {
  const char *from, *to, *words;
};

TEST(MagnitudesTest, NumbersInAForgottenUnitAreTold) {
  const Odd table[] = {
      // 10 Pa over 2000 x 9.81 x 15 Pa = 3.4e-5
      {"\"10 kPa\"", "10",
       "a cohesion of 10 Pa is 3.4e-05 times the weight of the soil 15 m high, 294.3 kPa"},
      {"\"10 kPa\"", "10", "Try \"10 kPa\", or 0."},
      {"\"10 kPa\"", "\"10 GPa\"", "it will not yield under its own weight"},
      {"2000.0", "20", "a density of 20 kg/m3 is outside what soil has, 400 to 5000"},
      {"2000.0", "20", "Try unit_weight = \"20 kN/m3\""},
      {"2000.0", "2.0", "Try density = \"2 t/m3\""},
      {"2000.0", "120", "Try unit_weight = \"120 pcf\""},
      {"2000.0", "20000", "Try unit_weight = \"2e+04 N/m3\""},
      {"\"20 deg\"", "\"0.5 deg\"", "a friction angle of 0.5 deg is outside what soils have"},
      {"\"20 deg\"", "\"70 deg\"", "a friction angle of 70 deg is outside what soils have"},
      {"\"100 MPa\"", "\"300 GPa\"", "faster than in any rock"},
      {"-9.81]", "9.81]", "gravity points up. Try a negative number for y"},
  };
  for (const Odd& odd : table) {
    std::string text = replaced(slope_text, odd.from, odd.to);
    text = replaced(text, "dilation_angle = \"9 deg\"", "dilation_angle = 0");
    std::string all;
    for (const std::string& warning : warnings(read_scene_text(text, "slope.toml")))
      all += warning + "\n";
    EXPECT_NE(all.find(odd.words), std::string::npos) << odd.to << ": " << all;
  }
}

TEST(MagnitudesTest, WhatSoilsHaveIsNotTold) {
  const Odd table[] = {
      {"2000.0", "900", ""},      // peat
      {"2000.0", "4500", ""},     // ore
      {"\"10 kPa\"", "0", ""},    // sand
      {"\"10 kPa\"", "500", ""},  // moist sand, 1.7e-3 of the weight
      {"\"10 kPa\"", "\"30 MPa\"", ""},
      {"\"20 deg\"", "\"9 deg\"", ""},
      {"\"20 deg\"", "\"55 deg\"", ""},
  };
  for (const Odd& odd : table) {
    for (const std::string& warning : warnings(with(odd.from, odd.to)))
      ADD_FAILURE() << odd.to << ": " << warning;
  }
  // Without gravity scales may be chosen freely.
  const std::string free =
      replaced(replaced(slope_text, "[0.0, -9.81]", "[0, 0]"), "2000.0", "1.0");
  EXPECT_TRUE(warnings(read_scene_text(replaced(free, "\"geostatic\"", "\"zero\""), "a")).empty());
}

TEST(UnitWeightTest, TheSoilWeighsWhatIsWrittenUnderTheScenesGravity) {
  const Scene metric = with("density = 2000.0", "unit_weight = \"18.2 kN/m3\"");
  EXPECT_DOUBLE_EQ(metric.materials[0].density * 9.81, 18200.0);
  const Scene bare = with("density = 2000.0", "unit_weight = 18200");
  EXPECT_DOUBLE_EQ(bare.materials[0].density, metric.materials[0].density);
  // Tilted, and rounded to 10.
  const Scene tilted =
      read_scene_text(replaced(replaced(replaced(slope_text, "[0.0, -9.81]", "[6.0, -8.0]"),
                                        "\"geostatic\"", "\"zero\""),
                               "density = 2000.0", "unit_weight = \"20 kN/m3\""),
                      "slope.toml");
  EXPECT_DOUBLE_EQ(tilted.materials[0].density, 2000.0);
  // 120 pcf are 120 lb of mass in a cubic foot under standard gravity.
  const Scene pounds = with("density = 2000.0", "unit_weight = \"120 pcf\"");
  EXPECT_NEAR(pounds.materials[0].density, 120.0 * 16.018463 * 9.80665 / 9.81, 1e-4);
}

TEST(UnitWeightTest, IsNoDensityOffTheEarth) {
  for (const char* gravity : {"[0, 0]", "[0, -490.5]", "[0, -1.62]"}) {
    try {
      read_scene_text(replaced(replaced(slope_text, "[0.0, -9.81]", gravity), "density = 2000.0",
                               "unit_weight = \"18 kN/m3\""),
                      "slope.toml");
      ADD_FAILURE() << gravity << " was accepted";
    } catch (const SceneError& error) {
      // 18000 / 9.80665
      EXPECT_NE(std::string(error.what()).find("Try density = \"1835 kg/m3\""), std::string::npos)
          << error.what();
    }
  }
}

}  // namespace
}  // namespace scarp
