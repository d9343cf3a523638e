// SPDX-License-Identifier: BSD-3-Clause
/// Tree of boxes around facets.
#include "engine/boundary/facet_index.hpp"

#include <cstddef>
#include <limits>
#include <numeric>

#include "engine/boundary/facet_geometry.hpp"

namespace scarp {

using namespace geometry;

namespace {

constexpr std::uint32_t leaf_size = 4;

}  // namespace

AxisBox AxisBox::widened(double margin) const {
  AxisBox box = *this;
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] -= margin;
    box.high[a] += margin;
  }
  return box;
}

void AxisBox::take_in(const Vec3& point) {
  for (std::size_t a = 0; a < 3; ++a) {
    low[a] = std::min(low[a], point[a]);
    high[a] = std::max(high[a], point[a]);
  }
}

AxisBox AxisBox::nothing() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

AxisBox AxisBox::around(const Vec3& one, const Vec3& other) {
  AxisBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] = std::min(one[a], other[a]);
    box.high[a] = std::max(one[a], other[a]);
  }
  return box;
}

AxisBox AxisBox::around(const Facet& facet) {
  const Vec3 u = plus({}, facet.length_u, facet.tangent_u),
             v = plus({}, facet.length_v, facet.tangent_v);
  AxisBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] = facet.origin[a] + std::min(u[a], 0.0) + std::min(v[a], 0.0);
    box.high[a] = facet.origin[a] + std::max(u[a], 0.0) + std::max(v[a], 0.0);
  }
  return box;
}

FacetIndex::FacetIndex(std::span<const Facet> facets) {
  for (const Facet& facet : facets) boxes_.push_back(AxisBox::around(facet));
  order_.resize(boxes_.size());
  std::iota(order_.begin(), order_.end(), 0U);
  if (!order_.empty()) split(0, static_cast<std::uint32_t>(order_.size()));
}

void FacetIndex::split(std::uint32_t begin, std::uint32_t end) {
  AxisBox around = boxes_[order_[begin]], centres = around;
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

}  // namespace scarp
