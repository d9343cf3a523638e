// SPDX-License-Identifier: BSD-3-Clause
/// Grid of sites behind one facet.
#include "engine/boundary/face_grid.hpp"

#include <algorithm>
#include <cmath>

namespace scarp {

using namespace geometry;

namespace {

double columns_along(double length, double spacing) { return std::ceil(length / spacing - 1e-6); }

}  // namespace

FaceGrid::FaceGrid(const Facet& facet, int dimension, double spacing, std::int64_t layers)
    : facet_(facet), dimension_(dimension), spacing_(spacing), layers_(layers) {
  const double lengths[2] = {facet.length_u, facet.length_v};
  for (std::size_t a = 0; a + 1 < static_cast<std::size_t>(dimension); ++a) {
    columns_[a] = static_cast<std::int64_t>(std::min(columns_along(lengths[a], spacing), 1e15));
    margin_[a] = layers;
  }
}

double FaceGrid::sites(const Facet& facet, int dimension, double spacing, std::int64_t layers) {
  const auto depth = static_cast<double>(layers);
  double count = depth * (columns_along(facet.length_u, spacing) + 2.0 * depth);
  if (dimension == 3) count *= columns_along(facet.length_v, spacing) + 2.0 * depth;
  return count;
}

bool FaceGrid::is_near_end(const Site& site, std::int64_t count) const {
  const auto near_end = [count](std::int64_t column, std::int64_t columns) {
    return column < count || column >= columns - count;
  };
  return near_end(site.u, columns_[0]) || (dimension_ == 3 && near_end(site.v, columns_[1]));
}

std::array<Vec3, 2> FaceGrid::outward(const Site& site) const {
  const auto over = [](std::int64_t column, std::int64_t columns, const Vec3& tangent) {
    const double side = column < 0 ? -1.0 : column >= columns ? 1.0 : 0.0;
    return plus({}, side, tangent);
  };
  return {over(site.u, columns_[0], facet_.tangent_u), over(site.v, columns_[1], facet_.tangent_v)};
}

/// Columns are centred on the facet, so that a rest of its length is shared by both ends.
double FaceGrid::along(std::size_t axis, std::int64_t column) const {
  const double length = axis == 0 ? facet_.length_u : facet_.length_v;
  return 0.5 * length +
         (static_cast<double>(column) - 0.5 * static_cast<double>(columns_[axis] - 1)) * spacing_;
}

Vec3 FaceGrid::position(const Site& site, double depth) const {
  Vec3 p = plus(facet_.origin, along(0, site.u), facet_.tangent_u);
  if (dimension_ == 3) p = plus(p, along(1, site.v), facet_.tangent_v);
  return plus(p, -depth, facet_.normal);
}

bool FaceGrid::holds(const Vec3& point, double tolerance) const {
  const double thickness = static_cast<double>(layers_) * spacing_;
  const FacetCoordinates at = coordinates(facet_, dimension_, point);
  if (at.depth < -tolerance || at.depth > thickness + tolerance) return false;
  if (!at.above(facet_, thickness + spacing_)) return false;
  const auto nearest = [&](double value, double nudge) {
    return static_cast<std::int64_t>(std::floor((value + nudge * tolerance) / spacing_));
  };
  const double u = at.u - along(0, 0) + 0.5 * spacing_, v = at.v - along(1, 0) + 0.5 * spacing_;
  for (unsigned seam = 0; seam < 8; ++seam) {
    const auto nudge = [&](unsigned bit) { return (seam & bit) != 0U ? 1.0 : -1.0; };
    const Site site{nearest(u, nudge(1U)), dimension_ == 3 ? nearest(v, nudge(2U)) : 0,
                    nearest(at.depth, nudge(4U))};
    const bool outside = site.layer < 0 || site.layer >= layers_ || site.u < -margin_[0] ||
                         site.u >= columns_[0] + margin_[0] || site.v < -margin_[1] ||
                         site.v >= columns_[1] + margin_[1];
    if (!outside && kept_[index(site)]) return true;
  }
  return false;
}

}  // namespace scarp
