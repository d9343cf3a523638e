// SPDX-License-Identifier: BSD-3-Clause
/// Shapes of bodies, cut along lines.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/scene/shape_list.hpp"

namespace scarp {

/// A shape as the lattice fill sees it. Points on the surface, to a tolerance, count as inside, so
/// that bodies which share a face leave no gap and mirrored shapes hold mirrored points.
struct ColumnShape {
  std::string label;       ///< start of a message: "key 'body[1]' = box from (0, 0) to (1, 1)"
  Vec3 minimum{};          ///< lowest corner [m]
  Vec3 maximum{};          ///< highest corner [m]; the vertical one of some shapes is not known
  double tolerance = 0.0;  ///< reach of the surface [m]
  std::size_t up = 1;      ///< the vertical axis
  ShapeCut cut;

  /// Along the vertical axis; 2D ignores y.
  void column(double x, double y, std::vector<Range>& out) const {
    cut(up, {x, up == 1 ? 0.0 : y, 0.0}, out);
  }
};

/// The shape of body `index`; `scene` must outlive it. Errors: SceneError for an expression that
/// muParser rejects.
ColumnShape column_shape(const Scene& scene, std::size_t index);

}  // namespace scarp
