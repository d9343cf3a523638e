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

FaceGrid::FaceGrid(const Facet& facet, const WalledPart& part, int dimension, double spacing,
                   std::int64_t layers)
    : facet_(facet), dimension_(dimension), spacing_(spacing), layers_(layers) {
  const double lengths[2] = {facet.length_u, facet.length_v};
  for (std::size_t a = 0; a + 1 < static_cast<std::size_t>(dimension); ++a) {
    const auto [from, to] = part[a];
    const double inside = columns_along(to - from, spacing);
    // What reaches beyond the part: as many columns as fit best.
    const auto nearest = [&](double rest) { return std::floor(rest / spacing + 0.5 + 1e-6); };
    const double before = nearest(from), after = nearest(lengths[a] - to);
    columns_[a] = static_cast<std::int64_t>(before + inside + after);
    margin_[a] = layers;
    first_[a] = 0.5 * (from + to) - (before + 0.5 * (inside - 1.0)) * spacing;
  }
  kept_.resize(static_cast<std::size_t>(extent(0) * extent(1) * layers_));
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

Vec3 FaceGrid::position(const Site& site, double depth) const {
  Vec3 p = plus(facet_.origin, along(0, site.u), facet_.tangent_u);
  if (dimension_ == 3) p = plus(p, along(1, site.v), facet_.tangent_v);
  return plus(p, -depth, facet_.normal);
}

bool FaceGrid::holds(const Vec3& point, double tolerance) const {
  if (layers_ == 0) return false;
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
