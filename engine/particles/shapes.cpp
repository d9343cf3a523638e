// SPDX-License-Identifier: BSD-3-Clause
/// A body's shape with its place in messages and its tolerance.
#include "engine/particles/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace scarp {

ColumnShape column_shape(const Scene& scene, std::size_t index) {
  const Body& body = scene.bodies[index];
  const ShapeRow& row = row_of(body.shape);
  const ShapeExtent extent = row.extent(body.shape, scene.dimension);
  ColumnShape shape;
  shape.label = message_start(scene, body) + row.describe(body.shape, scene.dimension);
  shape.minimum = extent.minimum;
  shape.maximum = extent.maximum;
  shape.up = scene.dimension == 2 ? 1 : 2;
  // A billionth of a spacing, or more where coordinates are so large that round-off is more.
  shape.tolerance = 1e-9 * scene.spacing;
  for (std::size_t a = 0; a < 3; ++a) {
    const double largest = std::max(std::abs(extent.minimum[a]), std::abs(extent.maximum[a]));
    shape.tolerance = std::max(shape.tolerance, 16 * 2.2e-16 * largest);
  }
  shape.cut = row.cut(body.shape, scene.dimension, shape.tolerance, shape.label);
  return shape;
}

}  // namespace scarp
