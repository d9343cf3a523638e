// SPDX-License-Identifier: BSD-3-Clause
/// Where a point lies with respect to a flat piece of wall.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/scene/vector.hpp"

namespace scarp::geometry {

/// A point in the axes of a facet.
struct FacetCoordinates {
  double u = 0.0;      ///< along tangent_u from the origin [m]
  double v = 0.0;      ///< along tangent_v; 0 in 2D [m]
  double depth = 0.0;  ///< behind the face; negative on the soil side [m]

  bool above(const Facet& facet, double margin) const {
    return u >= -margin && u <= facet.length_u + margin && v >= -margin &&
           v <= facet.length_v + margin;
  }
  /// The nearest point of the facet.
  Vec3 foot(const Facet& facet) const {
    return plus(plus(facet.origin, std::clamp(u, 0.0, facet.length_u), facet.tangent_u),
                std::clamp(v, 0.0, facet.length_v), facet.tangent_v);
  }
  /// To the nearest point of the facet [m].
  double distance(const Facet& facet) const {
    return std::hypot(u - std::clamp(u, 0.0, facet.length_u),
                      v - std::clamp(v, 0.0, facet.length_v), depth);
  }
};

/// The corners of a facet; in 2D its two ends.
inline std::vector<Vec3> corners(const Facet& facet, int dimension) {
  const Vec3 u = plus(facet.origin, facet.length_u, facet.tangent_u);
  if (dimension == 2) return {facet.origin, u};
  return {facet.origin, u, plus(u, facet.length_v, facet.tangent_v),
          plus(facet.origin, facet.length_v, facet.tangent_v)};
}

inline FacetCoordinates coordinates(const Facet& facet, int dimension, const Vec3& point) {
  const Vec3 offset = minus(point, facet.origin);
  return {dot(offset, facet.tangent_u), dimension == 3 ? dot(offset, facet.tangent_v) : 0.0,
          -dot(offset, facet.normal)};
}

/// Whether the straight way from `before` to `now` passes the plane `depth` behind the facet from
/// its front, inside its footprint; what is no deeper than `tolerance` behind the plane counts as
/// before it.
inline bool goes_in(const Facet& facet, int dimension, const Vec3& before, const Vec3& now,
                    double depth, double tolerance = 0.0) {
  const double end = coordinates(facet, dimension, now).depth;
  if (!(end > depth + tolerance)) return false;
  const double start = coordinates(facet, dimension, before).depth;
  if (start > depth + tolerance) return false;
  const double share = std::max(0.0, depth - start) / (end - start);
  const Vec3 crossing = plus(before, share, minus(now, before));
  return coordinates(facet, dimension, crossing).above(facet, tolerance);
}

/// Whether the straight way from `foot` to `point` leaves the wall through this facet, from its
/// back to its soil side.
inline bool comes_out(const Facet& facet, int dimension, const Vec3& foot, const Vec3& point,
                      double tolerance) {
  const double before = coordinates(facet, dimension, foot).depth;
  const double after = coordinates(facet, dimension, point).depth;
  if (!(before > tolerance && after < -tolerance)) return false;
  const Vec3 crossing = plus(foot, before / (before - after), minus(point, foot));
  return coordinates(facet, dimension, crossing).above(facet, tolerance);
}

}  // namespace scarp::geometry
