// SPDX-License-Identifier: BSD-3-Clause
/// Closed outlines in a plane.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace scarp {

/// Two edges of an outline that cross; edge i goes from point i to the next.
struct Crossing {
  std::size_t first = 0, second = 0;
  std::array<double, 2> at{};
};

/// The first pair of edges that cross inside both, if any. Edges that only touch, at a point or
/// along each other, do not: a hole may be joined to the outline by a cut.
/// Cost: bounded; of outlines with tens of thousands of points not all pairs are looked at.
std::optional<Crossing> self_crossing(const std::vector<std::array<double, 2>>& points);

}  // namespace scarp
