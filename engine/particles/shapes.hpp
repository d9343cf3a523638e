// SPDX-License-Identifier: BSD-3-Clause
/// Shapes of bodies, cut into columns along the vertical axis (y in 2D, z in 3D).
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/particles/plane_cuts.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// A shape as the lattice fill sees it. Points on the surface, to a tolerance, count as inside, so
/// that bodies which share a face leave no gap and mirrored shapes hold mirrored points.
struct ColumnShape {
  std::string label;       ///< start of a message: "key 'body[1]' = box from (0, 0) to (1, 1)"
  Vec3 minimum{};          ///< lowest corner [m]
  Vec3 maximum{};          ///< highest corner [m]; the vertical one of a height field is not known
  double tolerance = 0.0;  ///< reach of the surface [m]
  /// Appends the vertical ranges inside the shape at (x, y), in any order, overlaps allowed; 2D
  /// ignores y. Errors: SceneError where a height cannot be found.
  std::function<void(double x, double y, std::vector<Range>& out)> column;
};

/// The shape of body `index`; `scene` must outlive it. Errors: SceneError for an expression that
/// muParser rejects.
ColumnShape column_shape(const Scene& scene, std::size_t index);

/// "(1, 2)" in 2D, "(1, 2, 3)" in 3D.
std::string point_text(const Vec3& point, int dimension);

}  // namespace scarp
