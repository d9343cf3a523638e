// SPDX-License-Identifier: BSD-3-Clause
/// Finds the facets near a point without asking all of them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// A tree of boxes around facets, halved at the median: a question costs the facets that are near
/// and the logarithm of their number, whatever their sizes.
class FacetIndex {
 public:
  FacetIndex() = default;
  FacetIndex(std::span<const Facet> facets, double reach);

  /// Puts into `found`, in ascending order, the number of every facet whose box, parallel to the
  /// axes, is within `reach` of the point along each axis: all that are within it, and some more.
  void near(const Vec3& point, std::vector<std::uint32_t>& found) const;
  /// The same for every facet whose box is within reach of that of `facet`.
  void near(const Facet& facet, std::vector<std::uint32_t>& found) const;

 private:
  struct Box {
    Vec3 low{}, high{};
  };
  /// The left child follows its parent; a leaf has no right one.
  struct Node {
    Box box;
    std::uint32_t right = 0, begin = 0, end = 0;
  };
  static Box box_of(const Facet& facet, double margin);
  void split(std::uint32_t begin, std::uint32_t end);
  void find(const Box& asked, std::vector<std::uint32_t>& found) const;

  std::vector<Box> boxes_;  ///< of the facets, widened by the reach
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace scarp
