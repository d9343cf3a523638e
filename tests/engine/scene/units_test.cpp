// SPDX-License-Identifier: BSD-3-Clause
/// Units of scene values.
#include "engine/scene/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scarp {
namespace {

using kernels::Unit;

struct Good {
  const char* text;
  Unit unit;
  double value;
};

TEST(UnitsTest, ConvertsEveryKindOfUnitToSi) {
  const Good table[] = {
      {"100 MPa", Unit::pressure, 100e6},
      {"10kPa", Unit::pressure, 10e3},
      {"2 GPa", Unit::pressure, 2e9},
      {"5 kN/m2", Unit::pressure, 5e3},
      {"0.25 m", Unit::length, 0.25},
      {"4 mm", Unit::length, 0.004},
      {" 1e2\tcm ", Unit::length, 1.0},
      {"+1 km", Unit::length, 1000.0},
      {"10 s", Unit::time, 10.0},
      {"3 ms", Unit::time, 0.003},
      {"2 min", Unit::time, 120.0},
      {"-3 m/s", Unit::velocity, -3.0},
      {"36 km/h", Unit::velocity, 10.0},
      {"9.81 m/s2", Unit::acceleration, 9.81},
      {"9.81 m/s^2", Unit::acceleration, 9.81},
      {"1800 kg/m3", Unit::density, 1800.0},
      {"1.8 t/m3", Unit::density, 1800.0},
      {"180 deg", Unit::angle, std::acos(-1.0)},
      {"0.5 rad", Unit::angle, 0.5},
      {".5 m", Unit::length, 0.5},
      {"20 kN/m^2", Unit::pressure, 20e3},
      {"3 N/m^2", Unit::pressure, 3.0},
      {"1 MN/m2", Unit::pressure, 1e6},
      {"18.2 kN/m3", Unit::unit_weight, 18.2e3},
      {"18.2 kN/m^3", Unit::unit_weight, 18.2e3},
      {"10 ft", Unit::length, 3.048},
      {"10 feet", Unit::length, 3.048},
      {"1 foot", Unit::length, 0.3048},
      {"12 inches", Unit::length, 0.3048},
      {"180°", Unit::angle, std::acos(-1.0)},
      {"180 degrees", Unit::angle, std::acos(-1.0)},
      {"18.2 kN/m³", Unit::unit_weight, 18.2e3},
      {"5 kN/m²", Unit::pressure, 5e3},
      {"9.81 m/s²", Unit::acceleration, 9.81},
      {"12 in", Unit::length, 0.3048},
      {"10 ft/s", Unit::velocity, 3.048},
      {"32.174 ft/s^2", Unit::acceleration, 32.174 * 0.3048},
  };
  for (const Good& good : table) {
    // One multiplication by a rounded factor: two roundings, four are allowed.
    EXPECT_DOUBLE_EQ(parse_quantity(good.text, good.unit), good.value) << good.text;
  }
}

TEST(UnitsTest, PoundsAndFeetAreTheInternationalOnes) {
  // The values of NIST SP 811, appendix B.8, to the seven digits it prints.
  const Good table[] = {{"1 psf", Unit::pressure, 4.788026e+01},
                        {"1 ksf", Unit::pressure, 4.788026e+04},
                        {"1 psi", Unit::pressure, 6.894757e+03},
                        {"1 pcf", Unit::unit_weight, 1.570875e+02}};
  for (const Good& good : table) {
    EXPECT_NEAR(parse_quantity(good.text, good.unit) / good.value, 1.0, 1e-6) << good.text;
  }
}

struct Bad {
  const char* text;
  Unit unit;
  const char* words;
};

TEST(UnitsTest, NamesWhatIsAcceptedWhenItRefuses) {
  const Bad table[] = {
      {"20 deg", Unit::length,
       "'deg' is the unit of an angle, but a length is needed. Try one of m, mm"},
      {"20 kpa", Unit::pressure, "unknown unit 'kpa' for a pressure. Did you mean 'kPa'?"},
      {"20", Unit::length, "no unit. Try one of m, mm, cm, km"},
      {"", Unit::time, "a time is needed"},
      {"   ", Unit::time, "a time is needed"},
      {"deg", Unit::angle, "an angle is needed"},
      {"+-3 m", Unit::length, "a length is needed"},
      {"1e999 m", Unit::length, "too large or too near to 0"},
      {"1e308 km", Unit::length, "not a finite number"},
      {"inf m", Unit::length, "not a finite number"},
      {"nan s", Unit::time, "not a finite number"},
      {"0x10 m", Unit::length, "unknown unit 'x10 m'"},
      {"1,5 m", Unit::length, "a comma stands in the number. Try a decimal point, \"1.5 m\""},
      {"-0,25 m", Unit::length, "Try a decimal point, \"-0.25 m\""},
      {"1, m", Unit::length, "unknown unit ', m'"},
      {"1e-999 m", Unit::length, "too large or too near to 0"},
      {"18 kN/m3", Unit::density, "Try unit_weight = \"18 kN/m3\" in its place"},
      {"20 kN/m3", Unit::pressure, "'kN/m3' is the unit of a unit weight"},
      {"120 lb", Unit::unit_weight, "Try one of kN/m3, kN/m^3, N/m3, N/m^3, pcf"},
      {"1.5", Unit::none, "a plain number"},
  };
  for (const Bad& bad : table) {
    try {
      parse_quantity(bad.text, bad.unit);
      ADD_FAILURE() << bad.text << " was accepted";
    } catch (const UnitError& error) {
      EXPECT_NE(std::string(error.what()).find(bad.words), std::string::npos) << error.what();
    }
  }
}

TEST(UnitsTest, BareNumbersAreSiButAnglesNeedTheirUnit) {
  EXPECT_EQ(check_bare_number(0.25, Unit::length), 0.25);
  EXPECT_EQ(check_bare_number(0.0, Unit::angle), 0.0);
  EXPECT_THROW(check_bare_number(20.0, Unit::angle), UnitError);
  EXPECT_THROW(check_bare_number(std::nan(""), Unit::length), UnitError);
  EXPECT_THROW(check_bare_number(std::numeric_limits<double>::infinity(), Unit::none), UnitError);
}

}  // namespace
}  // namespace scarp
