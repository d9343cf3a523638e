// SPDX-License-Identifier: BSD-3-Clause
/// Tree of boxes around facets.
#include "engine/boundary/facet_index.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "engine/boundary/facet_geometry.hpp"

namespace scarp {

using namespace geometry;

namespace {

constexpr std::uint32_t leaf_size = 4;

}  // namespace

FacetIndex::Box FacetIndex::box_of(const Facet& facet, double margin) {
  const Vec3 u = plus({}, facet.length_u, facet.tangent_u),
             v = plus({}, facet.length_v, facet.tangent_v);
  Box box;
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] = facet.origin[a] + std::min(u[a], 0.0) + std::min(v[a], 0.0) - margin;
    box.high[a] = facet.origin[a] + std::max(u[a], 0.0) + std::max(v[a], 0.0) + margin;
  }
  return box;
}

FacetIndex::FacetIndex(std::span<const Facet> facets, double reach) {
  for (const Facet& facet : facets) boxes_.push_back(box_of(facet, reach));
  order_.resize(boxes_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  if (!order_.empty()) split(0, static_cast<std::uint32_t>(order_.size()));
}

void FacetIndex::split(std::uint32_t begin, std::uint32_t end) {
  Box around = boxes_[order_[begin]], centres = around;
  const auto centre = [this](std::uint32_t facet, std::size_t a) {
    return boxes_[facet].low[a] + boxes_[facet].high[a];
  };
  for (std::size_t a = 0; a < 3; ++a) {
    centres.low[a] = centres.high[a] = centre(order_[begin], a);
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint32_t facet = order_[k];
      around.low[a] = std::min(around.low[a], boxes_[facet].low[a]);
      around.high[a] = std::max(around.high[a], boxes_[facet].high[a]);
      centres.low[a] = std::min(centres.low[a], centre(facet, a));
      centres.high[a] = std::max(centres.high[a], centre(facet, a));
    }
  }
  const std::size_t node = nodes_.size();
  nodes_.push_back({around, 0, begin, end});
  if (end - begin <= leaf_size) return;
  const Vec3 extent = minus(centres.high, centres.low);
  const auto axis =
      static_cast<std::size_t>(std::max_element(extent.begin(), extent.end()) - extent.begin());
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t left, std::uint32_t right) {
                     return centre(left, axis) < centre(right, axis);
                   });
  split(begin, middle);
  nodes_[node].right = static_cast<std::uint32_t>(nodes_.size());
  split(middle, end);
}

void FacetIndex::near(const Vec3& point, std::vector<std::uint32_t>& found) const {
  find({point, point}, found);
}
void FacetIndex::near(const Facet& facet, std::vector<std::uint32_t>& found) const {
  find(box_of(facet, 0.0), found);
}

void FacetIndex::find(const Box& asked, std::vector<std::uint32_t>& found) const {
  found.clear();
  if (nodes_.empty()) return;
  const auto holds = [&asked](const Box& box) {
    bool meets = true;
    for (std::size_t a = 0; a < 3; ++a)
      meets = meets && asked.high[a] >= box.low[a] && asked.low[a] <= box.high[a];
    return meets;
  };
  std::array<std::uint32_t, 64> waiting{};  // halves of halves of fewer than 2^32 facets
  std::size_t count = 1;
  while (count > 0) {
    const std::uint32_t index = waiting[--count];
    const Node& node = nodes_[index];
    if (!holds(node.box)) continue;
    if (node.right != 0) {
      waiting[count++] = node.right;
      waiting[count++] = index + 1;
      continue;
    }
    for (std::uint32_t k = node.begin; k < node.end; ++k) {
      if (holds(boxes_[order_[k]])) found.push_back(order_[k]);
    }
  }
  std::sort(found.begin(), found.end());
}

}  // namespace scarp
