// SPDX-License-Identifier: BSD-3-Clause
/// Where a rough wall goes on beyond its edge, behind a free-slip face that meets it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "engine/boundary/wall_surface.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// A dummy beyond the edges of its facet that stands only while a free-slip face closes the corner
/// over each edge in `over`. The face may move, go, or come with time.
struct SmoothCorner {
  std::size_t dummy = 0;
  std::array<Vec3, 2> over{};  ///< ways out across the edges; zero: none to close
};

/// Whether a facet closes the corner over an edge whose way out is `outward`: it faces back, the
/// point is near it and not deeper behind it than its wall is thick.
struct CornerReach {
  int dimension = 2;
  double thickness = 0.0;  ///< of the layers of dummies [m]
  double tolerance = 0.0;  ///< [m]

  bool is_near(const Facet& facet, const Vec3& point) const;
  double farthest() const;  ///< distance of a facet that is near [m]
  static bool faces_back(const Facet& facet, const Vec3& outward);
};
CornerReach corner_reach(const Scene& scene);

/// Whether free-slip walls that stand close the corner for a dummy at `point`.
bool stands_in_corner(const Scene& scene, const WallSurface& surface, const CornerReach& reach,
                      const SmoothCorner& corner, const Vec3& point, const WallPlacement& walls,
                      FacetSearch& search);

/// Where, as the scene draws it, a facet of another wall may be that comes near a point of this one
/// during the run.
AxisBox way_between(const Scene& scene, const CornerReach& reach, const Vec3& point,
                    const Wall& own, const Wall& other);

/// Whether two walls stay as they are to each other for as long as `own` stands.
bool stay_together(const Wall& own, const Wall& other);

}  // namespace scarp
