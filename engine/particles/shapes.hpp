// SPDX-License-Identifier: BSD-3-Clause
/// Shapes of bodies, cut along lines.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"
#include "engine/scene/shape_list.hpp"

namespace scarp {

/// A shape as the lattice fill sees it. Points within a tolerance of the surface are inside for its
/// cuts. Sites there belong to it as if they lay a little lower and, by much less, to the left and
/// in front: to the body below a face that slants, to that on the left or in front of an upright
/// one. So bodies that share a face neither both hold its sites nor both leave them, a body holds
/// those of one of two opposite faces, and mirrored slopes hold mirrored sites. What is round in
/// plan holds all, to keep its symmetry.
struct ColumnShape {
  std::string label;       ///< start of a message: "key 'body[1]' = box from (0, 0) to (1, 1)"
  Vec3 minimum{};          ///< lowest corner [m]
  Vec3 maximum{};          ///< highest corner [m]; the vertical one of some shapes is not known
  double tolerance = 0.0;  ///< reach of the surface [m], the same for all bodies of a scene
  Vec3 begin{};            ///< from the low end of a range to that of its sites, on each axis [m]
  std::size_t up = 1;      ///< the vertical axis
  ShapeCut cut, sites;

  /// Along the vertical axis; 2D ignores y.
  void column(double x, double y, std::vector<Range>& out) const {
    cut(up, {x, up == 1 ? 0.0 : y, 0.0}, out);
  }
};

/// The shapes of all bodies, in their order; `scene` must outlive them. Errors: SceneError for an
/// expression that muParser rejects.
std::vector<ColumnShape> column_shapes(const Scene& scene);

}  // namespace scarp
