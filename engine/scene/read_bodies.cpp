// SPDX-License-Identifier: BSD-3-Clause
/// [[body]]: a material and exactly one shape; with the small readers of points the other parts
/// share.
#include <fmt/format.h>

#include <algorithm>

#include "engine/scene/read_parts.hpp"
#include "engine/scene/shape_list.hpp"

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

Body read_body(const Value& item, int dimension, const std::vector<std::string>& materials) {
  Keys shapes, keys = {"material", "velocity", "velocity_field"};
  for (const ShapeRow* row : shape_list()) {
    for (const std::string_view key : {row->key, row->other.key}) {
      if (key.empty()) continue;
      shapes.push_back(key);
      keys.push_back(key);
    }
    if (!row->companion.key.empty()) keys.push_back(row->companion.key);
  }
  const Table table = item.table(keys);
  Body body;
  body.line = item.line();
  const Value material = table.require("material", "\"clay\"");
  body.material = material.text();
  if (std::find(materials.begin(), materials.end(), body.material) == materials.end()) {
    material.fail(
        fmt::format("no [[material]] has this name. {}", did_you_mean(body.material, materials)));
  }
  const std::string_view shape = table.require_one_of(shapes);
  for (const ShapeRow* row : shape_list()) {
    if (row->key == shape || row->other.key == shape) {
      const auto read = row->key == shape ? row->read : row->other.read;
      body.shape = read(table, table.require(shape, "..."), dimension);
    } else if (const auto companion = table.find(row->companion.key)) {
      companion->fail(std::string(row->companion.misplaced));
    }
  }
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
