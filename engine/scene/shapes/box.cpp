// SPDX-License-Identifier: BSD-3-Clause
/// Boxes parallel to the axes.
#include <fmt/format.h>

#include "engine/scene/read_parts.hpp"
#include "engine/scene/shape_list.hpp"
#include "engine/scene/text_lines.hpp"
#include "engine/scene/validate_parts.hpp"

namespace scarp {
namespace {

const Box& box_of(const Body::Shape& shape) { return std::get<Box>(shape); }

Body::Shape read(const input::Table&, const input::Value& value, int dimension) {
  return input::read_box(value.table({"min", "max"}), dimension);
}

void check(const Body::Shape& shape, int dimension, const std::string& path) {
  const Box& box = box_of(shape);
  checks::vector(box.minimum, dimension, checks::largest_length, path + ".box.min");
  checks::vector(box.maximum, dimension, checks::largest_length, path + ".box.max");
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d) {
    checks::rule(box.maximum[d] > box.minimum[d], path + ".box.max",
                 fmt::format("{}", box.maximum[d]),
                 "it is not above min in every direction. Try min = [0, 0], max = [1, 1].");
  }
}

void write(const Body::Shape& shape, TextLines& lines) {
  lines.add("box.min", box_of(shape).minimum);
  lines.add("box.max", box_of(shape).maximum);
}

ShapeExtent extent(const Body::Shape& shape, int) {
  return {box_of(shape).minimum, box_of(shape).maximum};
}

std::string describe(const Body::Shape& shape, int dimension) {
  return from_to("box", extent(shape, dimension), dimension);
}

ShapeCut cut(const Body::Shape& shape, int, double, const std::string&) {
  return [box = &box_of(shape)](std::size_t axis, const Vec3&, std::vector<Range>& out) {
    out.push_back({box->minimum[axis], box->maximum[axis]});
  };
}

void corners(const Body::Shape& shape, int, std::size_t axis, std::vector<double>& out) {
  out.push_back(box_of(shape).minimum[axis]);
  out.push_back(box_of(shape).maximum[axis]);
}

double cost(const Body::Shape&) { return 5.0; }

}  // namespace

const ShapeRow box_row{"box",  {},  read,  check, write,   describe,
                       extent, cut, false, false, corners, cost};

}  // namespace scarp
