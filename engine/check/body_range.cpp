// SPDX-License-Identifier: BSD-3-Clause
/// Extents of shapes, and tops of height fields by their columns.
#include "engine/check/body_range.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

#include "engine/particles/shapes.hpp"
#include "engine/scene/shape_list.hpp"

namespace scarp {
namespace {

constexpr double most_columns = 300.0;  ///< along each axis in plan

BodyRange range_of_columns(const ColumnShape& shape, double spacing) {
  const auto pieces = [&](std::size_t axis) {
    const double length = shape.maximum[axis] - shape.minimum[axis];
    return static_cast<int>(std::clamp(length / spacing, 1.0, most_columns));
  };
  const int along = pieces(0), across = shape.up == 2 ? pieces(1) : 0;
  BodyRange found{shape.minimum[shape.up], shape.minimum[shape.up]};
  std::vector<Range> column;
  for (int i = 0; i <= along; ++i) {
    for (int j = 0; j <= across; ++j) {
      const double x =
          shape.minimum[0] + (shape.maximum[0] - shape.minimum[0]) * i / std::max(along, 1);
      const double y =
          shape.minimum[1] + (shape.maximum[1] - shape.minimum[1]) * j / std::max(across, 1);
      column.clear();
      shape.column(x, y, column);
      for (const Range& range : column) found.high = std::max(found.high, range.high);
    }
  }
  return found;
}

}  // namespace

std::size_t gravity_axis(const Scene& scene) {
  const auto smaller = [](double a, double b) { return std::abs(a) < std::abs(b); };
  return static_cast<std::size_t>(
      std::max_element(scene.gravity.begin(), scene.gravity.end(), smaller) -
      scene.gravity.begin());
}

std::vector<BodyRange> body_ranges(const Scene& scene, std::size_t axis) {
  const std::vector<ColumnShape> shapes = column_shapes(scene);
  std::vector<BodyRange> ranges;
  for (std::size_t b = 0; b < shapes.size(); ++b) {
    const bool height_field = std::holds_alternative<HeightField>(scene.bodies[b].shape);
    ranges.push_back(height_field && axis == shapes[b].up
                         ? range_of_columns(shapes[b], scene.spacing)
                         : BodyRange{shapes[b].minimum[axis], shapes[b].maximum[axis]});
  }
  return ranges;
}

}  // namespace scarp
