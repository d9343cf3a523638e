// SPDX-License-Identifier: BSD-3-Clause
/// A body's shape with its place in messages, its tolerance and what becomes of sites on its faces.
#include "engine/particles/shapes.hpp"

#include <algorithm>
#include <cmath>

namespace scarp {
namespace {

/// A billionth of a spacing, or more where coordinates are so large that round-off is more.
double tolerance_of(const Scene& scene, const std::vector<ShapeExtent>& extents) {
  double tolerance = 1e-9 * scene.spacing;
  for (const ShapeExtent& extent : extents) {
    for (std::size_t a = 0; a < 3; ++a) {
      const double largest = std::max(std::abs(extent.minimum[a]), std::abs(extent.maximum[a]));
      tolerance = std::max(tolerance, 16 * 2.2e-16 * largest);
    }
  }
  return tolerance;
}

}  // namespace

std::vector<ColumnShape> column_shapes(const Scene& scene) {
  std::vector<ShapeExtent> extents;
  for (const Body& body : scene.bodies)
    extents.push_back(row_of(body.shape).extent(body.shape, scene.dimension));
  const double tolerance = tolerance_of(scene, extents);
  std::vector<ColumnShape> shapes;
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const Body& body = scene.bodies[b];
    const ShapeRow& row = row_of(body.shape);
    ColumnShape shape;
    shape.label = message_start(scene, body) + row.describe(body.shape, scene.dimension);
    shape.minimum = extents[b].minimum;
    shape.maximum = extents[b].maximum;
    shape.up = scene.dimension == 2 ? 1 : 2;
    shape.tolerance = tolerance;
    for (std::size_t a = 0; a < 3; ++a)
      shape.begin[a] = row.round && (a != 2) ? -tolerance : tolerance;
    shape.cut = row.cut(body.shape, scene.dimension, tolerance, shape.label);
    shape.sites = row.sites ? row.sites(body.shape, tolerance) : shape.cut;
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

}  // namespace scarp
