// SPDX-License-Identifier: BSD-3-Clause
/// [[wall]]: a name, a kind, exactly one shape, and what it does in the course of the stages.
#include <fmt/format.h>

#include "engine/scene/facets.hpp"
#include "engine/scene/read_parts.hpp"

namespace scarp::input {
namespace {

using kernels::Unit;

std::vector<Facet> read_rectangle(const Value& value) {
  const Table table = value.table({"origin", "u", "v"});
  const auto vector = [&](std::string_view key) {
    return read_vector(table.require(key, "[1, 0, 0]"), Unit::length, 3);
  };
  return {rectangle_facet(vector("origin"), vector("u"), vector("v"))};
}

std::vector<Facet> read_plane(const Value& value, int dimension) {
  const Table table = value.table({"point", "normal", "size"});
  const char* example = dimension == 2 ? "[0, 1]" : "[0, 0, 1]";
  const Vec3 point = read_vector(table.require("point", example), Unit::length, dimension);
  const Vec3 normal = read_vector(table.require("normal", example), Unit::none, dimension);
  const double size = table.require("size", "10.0").number(Unit::length);
  return {plane_facet(point, normal, size, dimension)};
}

std::vector<Facet> read_faces(const Value& value, int dimension) {
  const Table table = value.table({"min", "max", "open"});
  std::vector<std::string> open;
  if (const auto faces = table.find("open")) {
    for (const Value& face : faces->items()) open.push_back(face.text());
  }
  return box_facets(read_box(table, dimension), open, dimension);
}

std::vector<Facet> read_shape(std::string_view shape, const Value& value, int dimension) {
  if (shape == "line" && dimension == 3) {
    value.fail("a line needs dimension = 2. Try rectangle, plane or box in 3D.");
  }
  if (shape == "rectangle" && dimension == 2) {
    value.fail("a rectangle needs dimension = 3. Try line, plane or box in 2D.");
  }
  const std::vector<std::array<double, 2>> points =
      shape == "line" ? read_pairs(value, 2) : std::vector<std::array<double, 2>>{};
  if (shape == "line") return line_facets(points);
  if (shape == "rectangle") return read_rectangle(value);
  if (shape == "plane") return read_plane(value, dimension);
  return read_faces(value, dimension);
}

}  // namespace

Wall read_wall(const Value& item, int dimension) {
  const Table table =
      item.table({"name", "kind", "line", "rectangle", "plane", "box", "motion", "until"});
  Wall wall;
  wall.line = item.line();
  wall.name = table.require("name", "\"base\"").text();
  wall.kind = static_cast<WallKind>(
      table.require("kind", "\"no_slip\" or \"free_slip\"").choice("no_slip|free_slip"));
  const std::string_view shape =
      table.require_one_of({std::begin(wall_shapes), std::end(wall_shapes)});
  const Value value = table.require(shape, "...");
  try {
    wall.facets = read_shape(shape, value, dimension);
  } catch (const GeometryError& error) {
    value.fail(fmt::format("{}.", error.what()));
  }
  if (const auto motion = table.find("motion")) {
    const Table parts = motion->table({"velocity", "from"});
    wall.velocity =
        read_vector(parts.require("velocity", dimension == 2 ? "[0, -1]" : "[0, 0, -1]"),
                    Unit::velocity, dimension);
    if (const auto from = parts.find("from")) wall.moves_from = from->text();
  }
  if (const auto until = table.find("until")) wall.removed_at = until->text();
  return wall;
}

}  // namespace scarp::input
