// SPDX-License-Identifier: BSD-3-Clause
/// Hilbert order of cells, measured against the engine's Morton order.
#pragma once

#include <array>
#include <cstdint>

#include "engine/cells/cell_grid.hpp"

namespace scarp::bench {

/// Index along the Hilbert curve of a cell with coordinates below 2^bits. Source: Skilling (2004),
/// "Programming the Hilbert curve", AIP Conf. Proc. 707, 381.
inline std::uint64_t hilbert_key(std::array<std::uint32_t, 3> x, int dimension, int bits = 20) {
  const auto n = static_cast<std::size_t>(dimension);
  for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1) {
    const std::uint32_t p = q - 1;
    for (std::size_t i = 0; i < n; ++i) {
      if ((x[i] & q) != 0) {
        x[0] ^= p;
      } else {
        const std::uint32_t t = (x[0] ^ x[i]) & p;
        x[0] ^= t;
        x[i] ^= t;
      }
    }
  }
  for (std::size_t i = 1; i < n; ++i) x[i] ^= x[i - 1];
  std::uint32_t t = 0;
  for (std::uint32_t q = 1u << (bits - 1); q > 1; q >>= 1) {
    if ((x[n - 1] & q) != 0) t ^= q - 1;
  }
  for (std::size_t i = 0; i < n; ++i) x[i] ^= t;
  // The transposed index reads the bits of x[0], x[1], x[2] in turn, highest first: Morton's
  // interleaving with the first axis highest.
  return n == 3 ? morton_key({x[2], x[1], x[0]}) : morton_key({x[1], x[0], 0});
}

}  // namespace scarp::bench
