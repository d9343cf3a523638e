// SPDX-License-Identifier: BSD-3-Clause
/// When softer soil is offered, and when not.
#include "engine/check/softer_soil.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/scene/scene_reader.hpp"
#include "tests/engine/scene/scene_texts.hpp"

namespace scarp::check {
namespace {

constexpr double hour = 3600.0;

Scene stiff(const std::string& from = "", const std::string& to = "") {
  // M = 1.346 GPa; 2000 x 9.81 x 15 Pa/M = 2.2e-4
  const std::string text = replaced(slope_text, "\"100 MPa\"", "\"1 GPa\"");
  return read_scene_text(from.empty() ? text : replaced(text, from, to), "slope.toml");
}

TEST(SofterSoilTest, IsOfferedToLongRunsOfStiffSoilThatYields) {
  const auto note = softer_soil_note(stiff(), hour);
  ASSERT_TRUE(note);
  for (const char* words : {"strains it by 0.022 %", "viscosity_alpha = 0.2,"})
    EXPECT_NE(note->find(words), std::string::npos) << *note;
}

TEST(SofterSoilTest, IsNotOfferedElsewhere) {
  EXPECT_FALSE(softer_soil_note(stiff(), 500.0));
  EXPECT_FALSE(softer_soil_note(stiff(), std::nan("")));
  EXPECT_FALSE(softer_soil_note(stiff("\"1 GPa\"", "\"400 MPa\""), hour));  // 5.5e-4
  Scene weightless = stiff();
  weightless.gravity = {};
  EXPECT_FALSE(softer_soil_note(weightless, hour));
  Scene empty = stiff();
  empty.bodies.clear();
  EXPECT_FALSE(softer_soil_note(empty, hour));
  Scene viscous = stiff();
  viscous.numerics.viscosity_alpha = 0.6;
  EXPECT_FALSE(softer_soil_note(viscous, hour));
  Scene rock = stiff();
  rock.materials[0].model = LinearElastic{.youngs_modulus = 1e9, .poisson_ratio = 0.3};
  EXPECT_FALSE(softer_soil_note(rock, hour));
}

}  // namespace
}  // namespace scarp::check
