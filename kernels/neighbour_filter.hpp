// SPDX-License-Identifier: BSD-3-Clause
/// Exact member test of the list build: which candidates lie in reach of a cluster.
#pragma once

#include <cstdint>

#include "kernels/particle_view.hpp"
#include "kernels/simd.hpp"

namespace scarp::kernels {

/// Writes the positions (within the candidate arrays) of the points within the radius of any
/// particle of the cluster, in order, and returns how many. Pre: arrays padded by 8 with far
/// points; `out` has room for count + 8. Errors: none, hot path.
template <class Arch>
int filter_candidates(const CandidateView& view, std::int32_t* out) {
  using B = Batch<double, Arch>;
  constexpr int width = lanes<double, Arch>;
  int kept = 0;
  for (int k = 0; k < view.count; k += width) {
    const B x = B::load_unaligned(view.x + k), y = B::load_unaligned(view.y + k),
            z = B::load_unaligned(view.z + k);
    B nearest(1e300);
    for (int c = 0; c < view.cluster_count; ++c) {
      const B dx = x - B(view.cluster_x[c]), dy = y - B(view.cluster_y[c]),
              dz = z - B(view.cluster_z[c]);
      nearest = xsimd::min(nearest, dx * dx + dy * dy + dz * dz);
    }
    if (!xsimd::any(nearest <= B(view.radius_squared))) continue;
    alignas(64) double distance[width];
    nearest.store_aligned(distance);
    for (int l = 0; l < width; ++l) {
      out[kept] = k + l;
      kept += distance[l] <= view.radius_squared;
    }
  }
  return kept;
}

}  // namespace scarp::kernels
