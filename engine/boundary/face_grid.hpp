// SPDX-License-Identifier: BSD-3-Clause
/// Grid of sites for dummy particles behind one facet.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/walled_part.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// Column along each tangent, and layer behind the face.
struct Site {
  std::int64_t u = 0, v = 0, layer = 0;
};

/// Columns 0 .. columns - 1 lie above the facet, `layers` more on each side serve the corners.
class FaceGrid {
 public:
  FaceGrid() = default;
  /// Columns are centred on `part` of the facet, so that a rest of its length is shared by both of
  /// its ends. Pre: the part is a spacing long or longer.
  FaceGrid(const Facet& facet, const WalledPart& part, int dimension, double spacing,
           std::int64_t layers);

  /// How many sites such a grid has, or a few less; for any length of the facet.
  static double sites(const Facet& facet, int dimension, double spacing, std::int64_t layers);

  bool is_above(const Site& site) const {
    return site.u >= 0 && site.u < columns_[0] && site.v >= 0 && site.v < columns_[1];
  }
  /// Not more than so many columns from an edge of its facet.
  bool is_near_end(const Site& site, std::int64_t count) const;
  /// Unit vectors along the facet's tangents over whose edges a site lies; zero: above it.
  std::array<Vec3, 2> outward(const Site& site) const;
  double depth(const Site& site) const {
    return (static_cast<double>(site.layer) + 0.5) * spacing_;
  }
  Vec3 position(const Site& site, double depth) const;

  /// Number of the column of a site, and how many there are.
  std::size_t column(const Site& site) const {
    return index(site) / static_cast<std::size_t>(layers_);
  }
  std::size_t columns() const { return kept_.size() / static_cast<std::size_t>(layers_); }

  void keep(const Site& site) { kept_[index(site)] = true; }
  /// Whether a point lies in the cell of a site that was kept; seams belong to both cells.
  bool holds(const Vec3& point, double tolerance) const;

  template <class Visit>
  void for_each_site(const Visit& visit) const {
    for (std::int64_t layer = 0; layer < layers_; ++layer) {
      for (std::int64_t u = -margin_[0]; u < columns_[0] + margin_[0]; ++u) {
        for (std::int64_t v = -margin_[1]; v < columns_[1] + margin_[1]; ++v) {
          visit(Site{u, v, layer});
        }
      }
    }
  }

 private:
  std::int64_t extent(std::size_t axis) const { return columns_[axis] + 2 * margin_[axis]; }
  std::size_t index(const Site& site) const {
    const std::int64_t u = site.u + margin_[0], v = site.v + margin_[1];
    return static_cast<std::size_t>((u * extent(1) + v) * layers_ + site.layer);
  }
  double along(std::size_t axis, std::int64_t column) const {
    return first_[axis] + static_cast<double>(column) * spacing_;
  }

  Facet facet_;
  int dimension_ = 2;
  double spacing_ = 0.0;
  std::int64_t layers_ = 0;  ///< 0: no grid
  std::array<std::int64_t, 2> columns_{1, 1};
  std::array<std::int64_t, 2> margin_{0, 0};
  std::array<double, 2> first_{0.0, 0.0};  ///< where column 0 is along each tangent [m]
  std::vector<bool> kept_;
};

}  // namespace scarp
