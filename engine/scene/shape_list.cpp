// SPDX-License-Identifier: BSD-3-Clause
/// Which shapes there are.
#include "engine/scene/shape_list.hpp"

#include <type_traits>

#include <fmt/format.h>

namespace scarp {
namespace {

constexpr const ShapeRow* rows[] = {&polygon_row, &box_row, &cylinder_row, &height_field_row};
static_assert(std::size(rows) == std::variant_size_v<Body::Shape>);

}  // namespace

std::span<const ShapeRow* const> shape_list() { return rows; }

const ShapeRow& row_of(const Body::Shape& shape) { return *rows[shape.index()]; }

std::string from_to(std::string_view noun, const ShapeExtent& extent, int dimension) {
  return fmt::format("{} from {} to {}", noun, point_text(extent.minimum, dimension),
                     point_text(extent.maximum, dimension));
}

std::string point_text(const Vec3& point, int dimension) {
  if (dimension == 2) return fmt::format("({:.9g}, {:.9g})", point[0], point[1]);
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", point[0], point[1], point[2]);
}

}  // namespace scarp
