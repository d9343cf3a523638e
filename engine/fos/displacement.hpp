// SPDX-License-Identifier: BSD-3-Clause
/// How far soil has moved.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/simulation.hpp"

namespace scarp {

inline double size_of(const Vec3& v) { return std::hypot(v[0], v[1], v[2]); }

/// The largest way of soil that is not lost since the positions `before`, and where the particle's
/// numbers begin.
inline double farthest(const std::vector<double>& before, const Simulation& simulation,
                       std::size_t* where = nullptr) {
  const std::vector<double> now = simulation.field("position"), lost = simulation.field("lost");
  double largest = 0.0;
  for (std::size_t i = 0; i + 2 < now.size(); i += 3) {
    if (lost[i / 3] != 0.0) continue;
    const double moved =
        std::hypot(now[i] - before[i], now[i + 1] - before[i + 1], now[i + 2] - before[i + 2]);
    if (!(moved > largest)) continue;
    largest = moved;
    if (where != nullptr) *where = i;
  }
  return largest;
}

}  // namespace scarp
