// SPDX-License-Identifier: BSD-3-Clause
/// Random points in a cube, with a few strays far away.
#pragma once

#include <cstddef>
#include <random>

#include "engine/cells/cell_grid.hpp"
#include "engine/particles/aligned_vector.hpp"

namespace scarp::test {

struct Points {
  AlignedVector<double> x, y, z;
  PointSpan span() const { return {x.data(), y.data(), z.data()}; }
};

inline Points random_points(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0.0, 6.0);
  Points p;
  for (std::size_t k = 0; k < count; ++k) {
    p.x.push_back(place(generator));
    p.y.push_back(place(generator));
    p.z.push_back(k % 97 == 0 ? 4000.0 + place(generator)
                              : place(generator));  // a few strays far away
  }
  return p;
}

}  // namespace scarp::test
