// SPDX-License-Identifier: BSD-3-Clause
/// Finds facets by where they are without asking all of them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// Parallel to the axes.
struct AxisBox {
  Vec3 low{}, high{};

  bool meets(const AxisBox& other) const {
    bool meets = true;
    for (std::size_t a = 0; a < 3; ++a)
      meets = meets && high[a] >= other.low[a] && low[a] <= other.high[a];
    return meets;
  }
  /// By so much on every side.
  AxisBox widened(double margin) const;
  void take_in(const Vec3& point);
  static AxisBox nothing();  ///< its low is above its high
  static AxisBox around(const Vec3& one, const Vec3& other);
  static AxisBox around(const Facet& facet);
};

/// What a question to an index needs; one for each thread.
struct FacetSearch {
  std::vector<std::uint32_t> found;
  std::uint64_t looked_at = 0;  ///< boxes, over all questions so far
};

/// A tree of boxes around facets, halved at the median: a question costs the facets that it finds
/// and the logarithm of their number, whatever their sizes.
class FacetIndex {
 public:
  FacetIndex() = default;
  explicit FacetIndex(std::span<const Facet> facets);

  /// Adds to `search.found`, in no order, the number of every facet of whose box meets(box) holds.
  /// Pre: it holds of a box wherever it holds of a part of it.
  template <class Meets>
  void find(const Meets& meets, FacetSearch& search) const;

 private:
  /// The left child follows its parent; a leaf has no right one.
  struct Node {
    AxisBox box;
    std::uint32_t right = 0, begin = 0, end = 0;
  };
  void split(std::uint32_t begin, std::uint32_t end);

  std::vector<AxisBox> boxes_;  ///< of the facets
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

template <class Meets>
void FacetIndex::find(const Meets& meets, FacetSearch& search) const {
  if (nodes_.empty()) return;
  std::array<std::uint32_t, 64> waiting{};  // halves of halves of fewer than 2^32 facets
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    ++search.looked_at;
    if (!meets(node.box)) continue;
    if (node.right != 0) {
      waiting[count++] = node.right;
      waiting[count++] = index + 1;
      continue;
    }
    search.looked_at += node.end - node.begin;
    for (std::uint32_t k = node.begin; k < node.end; ++k) {
      if (meets(boxes_[order_[k]])) search.found.push_back(order_[k]);
    }
  }
}

}  // namespace scarp
