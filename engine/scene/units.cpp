// SPDX-License-Identifier: BSD-3-Clause
/// The table of units a scene may use, and the parser of "number unit".
#include "engine/scene/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace scarp {
namespace {

using kernels::Unit;

struct UnitRow {
  Unit unit;
  std::string_view name;
  double factor;  // to SI
};

constexpr double degree = 3.14159265358979323846 / 180.0;
// The international foot and the avoirdupois pound under standard gravity, both exact.
constexpr double foot = 0.3048, inch = foot / 12.0;
constexpr double pound_force = 0.45359237 * 9.80665;
constexpr double pound_per_square_foot = pound_force / (foot * foot);

constexpr UnitRow rows[] = {
    {Unit::length, "m", 1.0},
    {Unit::length, "mm", 1e-3},
    {Unit::length, "cm", 1e-2},
    {Unit::length, "km", 1e3},
    {Unit::length, "ft", foot},
    {Unit::length, "in", inch},
    {Unit::time, "s", 1.0},
    {Unit::time, "us", 1e-6},
    {Unit::time, "ms", 1e-3},
    {Unit::time, "min", 60.0},
    {Unit::time, "h", 3600.0},
    {Unit::velocity, "m/s", 1.0},
    {Unit::velocity, "mm/s", 1e-3},
    {Unit::velocity, "cm/s", 1e-2},
    {Unit::velocity, "km/h", 1.0 / 3.6},
    {Unit::velocity, "ft/s", foot},
    {Unit::velocity, "in/s", inch},
    {Unit::acceleration, "m/s2", 1.0},
    {Unit::acceleration, "m/s^2", 1.0},
    {Unit::acceleration, "ft/s2", foot},
    {Unit::acceleration, "ft/s^2", foot},
    {Unit::density, "kg/m3", 1.0},
    {Unit::density, "kg/m^3", 1.0},
    {Unit::density, "g/cm3", 1e3},
    {Unit::density, "g/cm^3", 1e3},
    {Unit::density, "t/m3", 1e3},
    {Unit::density, "t/m^3", 1e3},
    {Unit::unit_weight, "kN/m3", 1e3},
    {Unit::unit_weight, "kN/m^3", 1e3},
    {Unit::unit_weight, "N/m3", 1.0},
    {Unit::unit_weight, "N/m^3", 1.0},
    {Unit::unit_weight, "pcf", pound_force / (foot * foot * foot)},
    {Unit::pressure, "Pa", 1.0},
    {Unit::pressure, "kPa", 1e3},
    {Unit::pressure, "MPa", 1e6},
    {Unit::pressure, "GPa", 1e9},
    {Unit::pressure, "N/m2", 1.0},
    {Unit::pressure, "N/m^2", 1.0},
    {Unit::pressure, "kN/m2", 1e3},
    {Unit::pressure, "kN/m^2", 1e3},
    {Unit::pressure, "MN/m2", 1e6},
    {Unit::pressure, "MN/m^2", 1e6},
    {Unit::pressure, "psf", pound_per_square_foot},
    {Unit::pressure, "ksf", 1e3 * pound_per_square_foot},
    {Unit::pressure, "psi", pound_force / (inch * inch)},
    {Unit::angle, "deg", degree},
    {Unit::angle, "rad", 1.0},
};

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blank = " \t";
  const auto first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

double finite(double value) {
  if (!std::isfinite(value)) throw UnitError("it is not a finite number. Try a finite one.");
  return value;
}

/// Equal but for capitals.
bool same_letters(std::string_view a, std::string_view b) {
  const auto small = [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char p, char q) { return small(p) == small(q); });
}

/// A unit as the table has it, from how people write it: "kN/m³", "30°", "10 feet".
std::string usual_spelling(std::string_view name) {
  constexpr std::pair<std::string_view, std::string_view> signs[] = {{"²", "2"}, {"³", "3"}},
                                                          words[] = {
                                                              {"°", "deg"},       {"degree", "deg"},
                                                              {"degrees", "deg"}, {"foot", "ft"},
                                                              {"feet", "ft"},     {"inch", "in"},
                                                              {"inches", "in"}};
  std::string usual(name);
  for (const auto& [sign, digit] : signs) {
    if (const std::size_t at = usual.find(sign); at != std::string::npos)
      usual.replace(at, sign.size(), digit);
  }
  for (const auto& [word, unit] : words) {
    if (usual == word) return std::string(unit);
  }
  return usual;
}

/// Throws if the number goes on behind a comma, "1,5 m": then a point is meant.
void refuse_decimal_comma(std::string_view number, std::string_view rest, std::string_view text) {
  if (rest.size() < 2 || rest[0] != ',' || rest[1] < '0' || rest[1] > '9') return;
  std::string with_point(text);
  with_point[number.size()] = '.';
  throw UnitError(fmt::format("a comma stands in the number. Try a decimal point, \"{}\".",
                              with_point.substr(0, 40)));
}

std::string example(Unit unit) {
  for (const UnitRow& row : rows) {
    if (row.unit == unit) return fmt::format("\"1.5 {}\"", row.name);
  }
  return "1.5";
}

}  // namespace

std::string_view quantity_name(Unit unit) {
  switch (unit) {
    case Unit::none:
      return "a plain number";
    case Unit::length:
      return "a length";
    case Unit::time:
      return "a time";
    case Unit::velocity:
      return "a velocity";
    case Unit::acceleration:
      return "an acceleration";
    case Unit::density:
      return "a density";
    case Unit::unit_weight:
      return "a unit weight";
    case Unit::pressure:
      return "a pressure";
    case Unit::angle:
      return "an angle";
    case Unit::choice:
      return "a choice";
  }
  return "a value";
}

std::string accepted_units(Unit unit) {
  std::string list;
  for (const UnitRow& row : rows) {
    if (row.unit != unit) continue;
    if (!list.empty()) list += ", ";
    list += row.name;
  }
  return list;
}

double check_bare_number(double value, Unit unit) {
  finite(value);
  if (unit == Unit::angle && value != 0.0) {
    throw UnitError(
        fmt::format("an angle needs its unit. Try \"{} deg\" or \"{} rad\".", value, value));
  }
  return value;
}

double parse_quantity(std::string_view text, Unit unit) {
  std::string_view rest = trimmed(text);
  if (!rest.empty() && rest.front() == '+') rest.remove_prefix(1);
  double number = 0.0;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  const bool doubled_sign = text.find("+-") != std::string_view::npos;
  if (error == std::errc::result_out_of_range) {
    throw UnitError(
        "the number is too large or too near to 0. Try one from 1e-300 to 1e300, or 0.");
  }
  if (error != std::errc{} || doubled_sign) {
    throw UnitError(fmt::format("{} is needed. Try a number, or text such as {}.",
                                quantity_name(unit), example(unit)));
  }
  const auto digits = static_cast<std::size_t>(end - rest.data());
  refuse_decimal_comma(rest.substr(0, digits), rest.substr(digits), rest);
  const std::string name = usual_spelling(trimmed(rest.substr(digits)));
  if (unit == Unit::none || unit == Unit::choice) {
    throw UnitError("a plain number without unit and quotes is needed. Try 1.5.");
  }
  if (name.empty()) {
    throw UnitError(fmt::format("the text has no unit. Try one of {}.", accepted_units(unit)));
  }
  const UnitRow* other = nullptr;
  for (const UnitRow& row : rows) {
    if (row.name != name) continue;
    if (row.unit == unit) return finite(finite(number) * row.factor);
    other = &row;
  }
  if (other != nullptr) {
    const bool weight_of = unit == Unit::density && other->unit == Unit::unit_weight;
    throw UnitError(fmt::format(
        "'{}' is the unit of {}, but {} is needed. Try {}.", name, quantity_name(other->unit),
        quantity_name(unit),
        weight_of ? fmt::format("unit_weight = \"{:.10g} {}\" in its place", number, name)
                  : fmt::format("one of {}", accepted_units(unit))));
  }
  const std::string why =
      fmt::format("unknown unit '{}' for {}.", name.substr(0, 20), quantity_name(unit));
  for (const UnitRow& row : rows) {  // "mpa" is not taken for "MPa": m and M differ by 1e9
    if (row.unit == unit && same_letters(row.name, name)) {
      throw UnitError(fmt::format("{} Did you mean '{}'?", why, row.name));
    }
  }
  throw UnitError(fmt::format("{} Try one of {}.", why, accepted_units(unit)));
}

}  // namespace scarp
