// SPDX-License-Identifier: BSD-3-Clause
/// Puts particles that are close together into the same cluster.
#include "engine/cells/compact_clusters.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/parallel.hpp"

namespace scarp {
namespace {

constexpr std::int64_t block_size = 64;

struct Point {
  std::array<double, 3> position;
  std::int32_t slot;
};

std::size_t longest_side(std::span<const Point> points) {
  std::array<double, 3> length{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto [low, high] = std::minmax_element(
        points.begin(), points.end(),
        [a](const Point& p, const Point& q) { return p.position[a] < q.position[a]; });
    length[a] = high->position[a] - low->position[a];
  }
  return static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
}

void halve(std::span<Point> points, std::size_t cluster_size) {
  if (points.size() <= cluster_size) return;
  const std::size_t a = longest_side(points);
  const std::size_t clusters = (points.size() + cluster_size - 1) / cluster_size;
  const std::size_t half = (clusters + 1) / 2 * cluster_size;
  std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half), points.end(),
                   [a](const Point& p, const Point& q) {
                     return p.position[a] < q.position[a] ||
                            (p.position[a] == q.position[a] && p.slot < q.slot);
                   });
  halve(points.first(half), cluster_size);
  halve(points.subspan(half), cluster_size);
}

/// A coordinate that can be ordered, whatever the state has come to.
double ordered(const double* values, std::int32_t slot) {
  return values == nullptr || std::isnan(values[slot]) ? 0.0 : values[slot];
}

}  // namespace

void compact_clusters(int threads, const PointSpan& points, int cluster_size,
                      std::span<std::int32_t> slots) {
  parallel_chunks(
      threads, static_cast<std::int64_t>(slots.size()), block_size,
      [&](std::int64_t begin, std::int64_t end) {
        std::array<Point, block_size> block;
        std::size_t count = 0;
        for (std::int64_t k = begin; k < end; ++k) {
          const std::int32_t slot = slots[static_cast<std::size_t>(k)];
          block[count++] = {
              {ordered(points.x, slot), ordered(points.y, slot), ordered(points.z, slot)}, slot};
        }
        halve(std::span(block).first(count), static_cast<std::size_t>(cluster_size));
        for (std::size_t k = 0; k < count; ++k)
          slots[static_cast<std::size_t>(begin) + k] = block[k].slot;
      });
}

}  // namespace scarp
