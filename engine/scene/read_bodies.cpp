// SPDX-License-Identifier: BSD-3-Clause
/// [[body]]: a material and exactly one shape; with the small readers of points the other parts
/// share.
#include <fmt/format.h>

#include <algorithm>

#include "engine/scene/read_parts.hpp"

namespace scarp::input {

using kernels::Unit;

Vec3 read_vector(const Value& value, Unit unit, int dimension) {
  const std::vector<double> numbers = value.numbers(unit, static_cast<std::size_t>(dimension));
  return {numbers[0], numbers[1], dimension == 3 ? numbers[2] : 0.0};
}

Box read_box(const Table& table, int dimension) {
  const char* example = dimension == 2 ? "[0, 0]" : "[0, 0, 0]";
  return {read_vector(table.require("min", example), Unit::length, dimension),
          read_vector(table.require("max", example), Unit::length, dimension)};
}

std::vector<std::array<double, 2>> read_pairs(const Value& value, std::size_t least) {
  std::vector<std::array<double, 2>> pairs;
  for (const Value& item : value.items()) {
    const std::vector<double> numbers = item.numbers(Unit::length, 2);
    pairs.push_back({numbers[0], numbers[1]});
  }
  if (pairs.size() < least) {
    value.fail(fmt::format("{} point(s) are too few. Try at least {}.", pairs.size(), least));
  }
  return pairs;
}

namespace {

Polygon read_polygon(const Table& body, int dimension) {
  Polygon polygon;
  polygon.points = read_pairs(body.require("polygon", "[[0, 0], [1, 0], [1, 1]]"), 3);
  if (dimension == 2) return polygon;
  const Value extrude =
      body.require("extrude", "[0.0, 1.0] (range of y; the outline lies in x and z)");
  const std::vector<double> range = extrude.numbers(Unit::length, 2);
  polygon.extrude = {range[0], range[1]};
  return polygon;
}

Cylinder read_cylinder(const Value& value, int dimension) {
  const Table table = value.table({"centre", "radius", "inner_radius", "height"});
  Cylinder cylinder;
  cylinder.centre = read_vector(table.require("centre", dimension == 2 ? "[0, 0]" : "[0, 0, 0]"),
                                Unit::length, dimension);
  cylinder.radius = table.require("radius", "1.0").number(Unit::length);
  if (const auto inner = table.find("inner_radius")) {
    cylinder.inner_radius = inner->number(Unit::length);
  }
  if (dimension == 3) {
    cylinder.height = table.require("height", "1.0").number(Unit::length);
  } else if (const auto height = table.find("height")) {
    height->fail("a disc in 2D has no height. Try without it, or dimension = 3.");
  }
  return cylinder;
}

HeightField read_height_field(const Value& value, int dimension) {
  if (dimension == 2) {
    value.fail("a height field needs dimension = 3. Try a polygon in 2D.");
  }
  const Table table = value.table({"plan", "base", "along", "centre", "profile", "expression"});
  HeightField field;
  const Value plan = table.require("plan", "[[0, 0], [10, 10]]");
  const auto corners = read_pairs(plan, 2);
  if (corners.size() != 2) plan.fail("it has more than two corners. Try [[x0, y0], [x1, y1]].");
  field.plan_minimum = corners[0];
  field.plan_maximum = corners[1];
  field.base = table.require("base", "0.0").number(Unit::length);

  const auto along = table.find("along"), centre = table.find("centre");
  if (table.require_one_of({"profile", "expression"}) == "expression") {
    if (along) along->fail("it belongs to a profile, not to an expression. Try without it.");
    if (centre) centre->fail("it belongs to a radial profile. Try without it.");
    field.kind = HeightField::Kind::expression;
    field.expression = table.require("expression", "\"x + y\"").text();
    return field;
  }
  const Value direction = table.require("along", "\"x\", \"y\" or \"radial\"");
  field.kind = static_cast<HeightField::Kind>(direction.choice("x|y|radial"));
  field.profile = read_pairs(table.require("profile", "[[0, 1], [10, 0]]"), 2);
  if (field.kind == HeightField::Kind::radial_profile) {
    const auto point = table.require("centre", "[0, 0]").numbers(Unit::length, 2);
    field.centre = {point[0], point[1]};
  } else if (centre) {
    centre->fail("it belongs to along = \"radial\". Try without it.");
  }
  return field;
}

}  // namespace

Body read_body(const Value& item, int dimension, const std::vector<std::string>& materials) {
  const Keys shapes = {"polygon", "box", "cylinder", "height_field"};
  const Table table = item.table({"material", "polygon", "extrude", "box", "cylinder",
                                  "height_field", "velocity", "velocity_field"});
  Body body;
  body.line = item.line();
  const Value material = table.require("material", "\"clay\"");
  body.material = material.text();
  if (std::find(materials.begin(), materials.end(), body.material) == materials.end()) {
    material.fail(
        fmt::format("no [[material]] has this name. {}", did_you_mean(body.material, materials)));
  }
  const std::string_view shape = table.require_one_of(shapes);
  const auto extrude = table.find("extrude");
  if (extrude && (shape != "polygon" || dimension == 2)) {
    extrude->fail("it belongs to a polygon with dimension = 3. Try without it.");
  }
  const Value value = table.require(shape, "...");
  if (shape == "polygon") body.shape = read_polygon(table, dimension);
  if (shape == "box") body.shape = read_box(value.table({"min", "max"}), dimension);
  if (shape == "cylinder") body.shape = read_cylinder(value, dimension);
  if (shape == "height_field") body.shape = read_height_field(value, dimension);
  if (const auto velocity = table.find("velocity")) {
    body.velocity = read_vector(*velocity, Unit::velocity, dimension);
  }
  if (const auto field = table.find("velocity_field")) {
    if (table.find("velocity")) {
      field->fail("the body also has a velocity. Try only one of the two.");
    }
    for (const Value& direction : field->items()) body.velocity_field.push_back(direction.text());
  }
  return body;
}

}  // namespace scarp::input
