// SPDX-License-Identifier: BSD-3-Clause
/// Soil between a base and a height over a plan, in 3D.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/errors.hpp"
#include "engine/scene/expression.hpp"
#include "engine/scene/read_parts.hpp"
#include "engine/scene/shape_list.hpp"
#include "engine/scene/text_lines.hpp"
#include "engine/scene/validate_parts.hpp"

namespace scarp {
namespace {

using kernels::Unit;
using Kind = HeightField::Kind;

const HeightField& field_of(const Body::Shape& shape) { return std::get<HeightField>(shape); }

Body::Shape read(const input::Table&, const input::Value& value, int dimension) {
  if (dimension == 2) {
    value.fail("a height field needs dimension = 3. Try a polygon in 2D.");
  }
  const input::Table table =
      value.table({"plan", "base", "along", "centre", "profile", "expression"});
  HeightField field;
  const input::Value plan = table.require("plan", "[[0, 0], [10, 10]]");
  const auto plan_corners = input::read_pairs(plan, 2);
  if (plan_corners.size() != 2)
    plan.fail("it has more than two corners. Try [[x0, y0], [x1, y1]].");
  field.plan_minimum = plan_corners[0];
  field.plan_maximum = plan_corners[1];
  field.base = table.require("base", "0.0").number(Unit::length);

  const auto along = table.find("along"), centre = table.find("centre");
  if (table.require_one_of({"profile", "expression"}) == "expression") {
    if (along) along->fail("it belongs to a profile, not to an expression. Try without it.");
    if (centre) centre->fail("it belongs to a radial profile. Try without it.");
    field.kind = Kind::expression;
    field.expression = table.require("expression", "\"x + y\"").text();
    return field;
  }
  const input::Value direction = table.require("along", "\"x\", \"y\" or \"radial\"");
  field.kind = static_cast<Kind>(direction.choice("x|y|radial"));
  field.profile = input::read_pairs(table.require("profile", "[[0, 1], [10, 0]]"), 2);
  if (field.kind == Kind::radial_profile) {
    const auto point = table.require("centre", "[0, 0]").numbers(Unit::length, 2);
    field.centre = {point[0], point[1]};
  } else if (centre) {
    centre->fail("it belongs to along = \"radial\". Try without it.");
  }
  return field;
}

void check(const Body::Shape& shape, int dimension, const std::string& path) {
  using checks::rule;
  const HeightField& field = field_of(shape);
  const std::string key = path + ".height_field";
  checks::choice(field.kind, Kind::expression, key);
  rule(dimension == 3, key, "...", "a height field needs dimension = 3. Try a polygon in 2D.");
  checks::point(field.plan_minimum, key + ".plan");
  checks::point(field.plan_maximum, key + ".plan");
  checks::ordered(field.plan_minimum[0], field.plan_maximum[0], key + ".plan");
  checks::ordered(field.plan_minimum[1], field.plan_maximum[1], key + ".plan");
  checks::inside(field.base, -checks::largest_length, checks::largest_length, key + ".base");
  if (field.kind == Kind::expression) {
    std::vector<Vec3> plan_corners;
    for (const double x : {field.plan_minimum[0], field.plan_maximum[0]}) {
      for (const double y : {field.plan_minimum[1], field.plan_maximum[1]})
        plan_corners.push_back({x, y, 0.0});
    }
    checks::formula(field.expression, "xy", plan_corners, key + ".expression");
    return;
  }
  checks::point(field.centre, key + ".centre");
  rule(field.profile.size() >= 2, key + ".profile", fmt::format("{} points", field.profile.size()),
       "a profile needs two points. Try [[0, 1], [10, 0]].");
  for (std::size_t i = 0; i < field.profile.size(); ++i) {
    const std::string item = fmt::format("{}.profile[{}]", key, i);
    checks::point(field.profile[i], item);
    rule(i == 0 || field.profile[i][0] >= field.profile[i - 1][0], item,
         fmt::format("[{}, {}]", field.profile[i][0], field.profile[i][1]),
         "the distance is below the one before. Try rising distances; equal ones make a vertical "
         "face.");
  }
}

void write(const Body::Shape& shape, TextLines& lines) {
  const HeightField& h = field_of(shape);
  lines.add("height_field.plan_minimum", h.plan_minimum);
  lines.add("height_field.plan_maximum", h.plan_maximum);
  lines.add("height_field.base", h.base);
  lines.add("height_field.along", h.kind);
  lines.add("height_field.centre", h.centre);
  lines.add("height_field.profile", h.profile);
  lines.add("height_field.expression", h.expression);
}

ShapeExtent extent(const Body::Shape& shape, int) {
  const HeightField& h = field_of(shape);
  double top = h.base;
  for (const auto& point : h.profile) top = std::max(top, point[1]);
  return {{h.plan_minimum[0], h.plan_minimum[1], h.base},
          {h.plan_maximum[0], h.plan_maximum[1], top}};
}

std::string describe(const Body::Shape& shape, int) {
  const HeightField& h = field_of(shape);
  return fmt::format("height field over x {} to {}, y {} to {}, base {}", h.plan_minimum[0],
                     h.plan_maximum[0], h.plan_minimum[1], h.plan_maximum[1], h.base);
}

/// Linear between the points of a profile, constant beyond its ends.
double profile_height(const std::vector<std::array<double, 2>>& profile, double distance) {
  const auto next =
      std::upper_bound(profile.begin(), profile.end(), distance,
                       [](double value, const auto& point) { return value < point[0]; });
  if (next == profile.begin()) return profile.front()[1];
  if (next == profile.end()) return profile.back()[1];
  const auto& [a, low] = *(next - 1);
  const auto& [b, high] = *next;
  return low + (high - low) * (distance - a) / (b - a);
}

using HeightFunction = std::function<double(double, double)>;

HeightFunction expression_height(const std::string& text, const std::string& label) {
  const auto fail = [label, text](const ExpressionError& error) {
    throw SceneError(fmt::format("{}: expression \"{}\" {} Try an expression of x and y.", label,
                                 text, error.what()));
  };
  try {
    return [expression = Expression(text, "xy"), fail](double x, double y) {
      try {
        return expression({x, y, 0.0});
      } catch (const ExpressionError& error) {
        fail(error);
      }
      return 0.0;
    };
  } catch (const ExpressionError& error) {
    fail(error);
  }
  return {};
}

HeightFunction height_function(const HeightField& field, const std::string& label) {
  const auto* f = &field;
  switch (field.kind) {
    case Kind::x_profile:
      return [f](double x, double) { return profile_height(f->profile, x); };
    case Kind::y_profile:
      return [f](double, double y) { return profile_height(f->profile, y); };
    case Kind::radial_profile:
      return [f](double x, double y) {
        return profile_height(f->profile, std::hypot(x - f->centre[0], y - f->centre[1]));
      };
    case Kind::expression:
      break;
  }
  return expression_height(field.expression, label);
}

ShapeCut cut(const Body::Shape& shape, int, double, const std::string& label) {
  const HeightField& field = field_of(shape);
  return [base = field.base, label, height = height_function(field, label)](
             std::size_t axis, const Vec3& at, std::vector<Range>& out) {
    if (axis != 2) return;
    const double top = height(at[0], at[1]);
    if (!(std::abs(top) <= checks::largest_length)) {
      throw SceneError(
          fmt::format("{}: the height at x = {:.9g}, y = {:.9g} is {}: not a finite length "
                      "below {} m. Try a profile or expression that is finite on the whole plan.",
                      label, at[0], at[1], top, checks::largest_length));
    }
    if (top > base) out.push_back({base, top});
  };
}

void corners(const Body::Shape& shape, int, std::size_t axis, std::vector<double>& out) {
  const HeightField& h = field_of(shape);
  if (axis < 2) out.insert(out.end(), {h.plan_minimum[axis], h.plan_maximum[axis]});
}

/// About as much for an expression.
double cost(const Body::Shape&) { return 50.0; }

}  // namespace

const ShapeRow height_field_row{"height_field", {},  read, check, write,   describe,
                                extent,         cut, true, false, corners, cost};

}  // namespace scarp
