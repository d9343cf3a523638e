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

/// Clay of 100 MPa on rock of so much, with this line more for each.
std::string contrast_warnings(const char* rock_modulus, const char* of_rock, const char* of_clay) {
  const std::string rock =
      std::string("[[material]]\nname = \"rock\"\nmodel = \"linear_elastic\"") +
      "\ndensity = 2000\npoisson_ratio = 0.3\nyoungs_modulus = \"" + rock_modulus + "\"\n" +
      of_rock + "\n[[body]]\nmaterial = \"rock\"\nbox = {min = [0, -5], max = [45, 0]}\n";
  const std::string text =
      replaced(slope_text, "density = 2000.0", std::string("density = 2000.0\n") + of_clay);
  std::string all;
  for (const std::string& warning :
       warnings(read_scene_text(replaced(text, "[[wall]]", rock + "\n[[wall]]"), "slope.toml")))
    all += warning + "\n";
  return all;
}

TEST(ContrastTest, TheMaterialThatMakesTheStepShortIsToldWithWhatHelps) {
  const std::string far = contrast_warnings("400 GPa", "", "");
  // Sound is sqrt(4000) = 63.2 times as fast.
  EXPECT_NE(far.find("material 'rock' makes the time step 63.2 times shorter than 'clay' needs"),
            std::string::npos)
      << far;
  EXPECT_NE(far.find("mass_scaling = 4e+03: a step 63.2 times longer"), std::string::npos) << far;
  EXPECT_NE(far.find("a Young's modulus of 0.025 times its own"), std::string::npos) << far;
  const std::string near = contrast_warnings("20 GPa", "mass_scaling = 1", "");
  EXPECT_NE(near.find("mass_scaling = 200: a step 14.1 times longer"), std::string::npos) << near;
  EXPECT_EQ(near.find("Young's modulus"), std::string::npos) << near;
  const std::string half = contrast_warnings("400 GPa", "mass_scaling = 10", "");
  EXPECT_NE(half.find("mass_scaling = 4e+03: a step 20 times longer"), std::string::npos) << half;
  EXPECT_NE(half.find("falls and swings 63.2 times"), std::string::npos) << half;
  for (const auto& [modulus, scaling] :
       {std::pair{"400 GPa", "mass_scaling = 4000"}, {"5 GPa", ""}})
    EXPECT_EQ(contrast_warnings(modulus, scaling, "").find("time step"), std::string::npos);
}

TEST(ContrastTest, SoilThatYieldsSlidesTooSlowlyWhereItIsScaled) {
  const std::string told = contrast_warnings("1 GPa", "mass_scaling = 10", "mass_scaling = 4");
  EXPECT_NE(
      told.find("material 'clay': it yields, and mass_scaling = 4 lets it slide and fall 2 times"),
      std::string::npos)
      << told;
  EXPECT_EQ(told.find("material 'rock': it yields"), std::string::npos) << told;
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
