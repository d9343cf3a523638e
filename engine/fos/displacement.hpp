// SPDX-License-Identifier: BSD-3-Clause
/// How far soil has moved.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

inline double size_of(const Vec3& v) { return std::hypot(v[0], v[1], v[2]); }

/// The largest way between two sets of positions, and where the particle's numbers begin.
inline double farthest(const std::vector<double>& before, const std::vector<double>& now,
                       std::size_t* where = nullptr) {
  double largest = 0.0;
  for (std::size_t i = 0; i + 2 < now.size(); i += 3) {
    const double moved =
        std::hypot(now[i] - before[i], now[i + 1] - before[i + 1], now[i + 2] - before[i + 2]);
    if (!(moved > largest)) continue;
    largest = moved;
    if (where != nullptr) *where = i;
  }
  return largest;
}

}  // namespace scarp
