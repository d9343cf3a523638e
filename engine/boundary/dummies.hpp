// SPDX-License-Identifier: BSD-3-Clause
/// Dummy particles that stand for the walls of a scene.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "engine/boundary/smooth_corner.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// The dummies in line behind one place of a face. How their stress varies along the normal is
/// taken from the soil near the first of them and near an inner point, which is a dummy without a
/// volume on the soil side of the face.
struct WallColumn {
  std::size_t first = 0, inner = 0;
};
inline constexpr std::size_t no_column = std::numeric_limits<std::size_t>::max();

/// Dummy particles before sorting; all at time 0 (walls not yet moved).
struct WallDummies {
  std::vector<Vec3> position;       ///< [m]
  std::vector<Vec3> normal;         ///< of the wall face it belongs to, towards the soil [-]
  std::vector<double> distance;     ///< behind that face, negative of inner points [m]
  std::vector<std::size_t> wall;    ///< index into Scene::walls
  std::vector<bool> near_edge;      ///< whether its wall ends within reach of the soil over it
  std::vector<std::size_t> column;  ///< index into `columns`, or `no_column`
  std::vector<WallColumn> columns;  ///< none where forces are not corrected
  std::vector<SmoothCorner> beside_smooth;  ///< those that come and go with a free-slip face
  CornerReach corner_reach;                 ///< of such faces
};

/// Layers of dummies that the support 2h needs; a soil particle that touches the face still sees it
/// full.
int wall_layers(const Scene& scene);

/// Layers of dummies behind every no-slip facet, spacing dx, first layer half a spacing behind the
/// face. Free-slip faces have none, for the soil's images stand behind them; nor do they take a
/// place from a no-slip wall that ends on, crosses or passes them.
/// Columns are centred on the facet, or on its part between walls that stand on it. At a concave
/// corner (another facet of either kind faces back over the edge) the grid goes on beyond the facet
/// by the thickness; free edges stay as they are. Where only a free-slip face that moves or goes
/// closes the corner, these dummies stand while it is there. Convex corners stay clean: a site is
/// dropped if the way to it from the face comes out of the wall through another facet or ends
/// within a quarter spacing of a no-slip facet's back, or, beyond an edge, if it is on the soil
/// side of another no-slip facet (inside its footprint and within the thickness). Sites in the cell
/// of one already placed, or closer than half a spacing to it, are dropped; walls that neither move
/// nor go are placed first. A dummy behind several faces belongs to the nearest plane; one above a
/// facet asks only facets it is above, and one of a lasting wall only lasting walls. Where
/// forces are corrected, the dummies in line behind a facet that belong to it form a column, unless
/// another facet stands between its face and its inner point. Time and memory are proportional to
/// the number of sites, and to that of the facets but for a logarithm. Source: layout after Bui et
/// al. 2008; numerics in kernels/EQUATIONS.md. Errors: SceneError if a facet is shorter than a
/// spacing or the count exceeds what memory holds.
WallDummies generate_dummies(const Scene& scene, const std::function<bool()>& stop = {});

}  // namespace scarp
