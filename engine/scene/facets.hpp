// SPDX-License-Identifier: BSD-3-Clause
/// Flat wall pieces from the shapes people think in; soil lies on the side the normal points to.
#pragma once

#include <string>
#include <vector>

#include "engine/errors.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// A shape that cannot be a wall; the reader adds file, line and key.
class GeometryError : public SceneError {
 public:
  using SceneError::SceneError;
};

/// 2D: one facet per segment, soil on the left of the direction of travel. Errors: GeometryError
/// for fewer than two points or a segment without length.
std::vector<Facet> line_facets(const std::vector<std::array<double, 2>>& points);

/// 3D rectangle with edge vectors `u` and `v` [m]; the normal is along u x v. Errors: GeometryError
/// unless u and v have length and stand at right angles.
Facet rectangle_facet(const Vec3& origin, const Vec3& u, const Vec3& v);

/// Square patch of edge `size` [m] centred at `point` (in 2D a line). Errors: GeometryError for a
/// normal without length, or a size that is not positive.
Facet plane_facet(const Vec3& point, const Vec3& normal, double size, int dimension);

/// Inside faces of a box but those named in `open` ("+y"). Errors: GeometryError for an unknown
/// face, all faces open, or an extent that is not positive.
std::vector<Facet> box_facets(const Box& box, const std::vector<std::string>& open, int dimension);

}  // namespace scarp
