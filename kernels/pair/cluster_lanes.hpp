// SPDX-License-Identifier: BSD-3-Clause
/// The particles of one cluster as lanes of a vector.
#pragma once

#include <cstdint>

#include "kernels/simd.hpp"

namespace scarp::kernels {

/// Moves values between the arrays of particles and vectors whose halves both stand for the cluster
/// that begins with particle `first`.
template <class Real, class Arch>
struct ClusterLanes {
  static constexpr int half = cluster_size<Real, Arch>;
  using B = Batch<Real, Arch>;
  std::int64_t first;

  /// One value of each particle's record, in both halves.
  SCARP_INLINE B load(const Real* records, int size, int slot) const {
    alignas(64) Real lane[lanes<Real, Arch>];
    for (int l = 0; l < half; ++l) lane[l] = lane[l + half] = records[(first + l) * size + slot];
    return B::load_aligned(lane);
  }
  /// Sums (or takes the maximum of) both halves, into every lane.
  SCARP_INLINE B fold(const B& value, bool maximum = false) const {
    alignas(64) Real lane[lanes<Real, Arch>];
    value.store_aligned(lane);
    for (int l = 0; l < half; ++l) {
      const Real low = lane[l], high = lane[l + half];
      lane[l] = lane[l + half] = maximum ? (low > high ? low : high) : low + high;
    }
    return B::load_aligned(lane);
  }
  /// Writes a folded value, unless nobody asks for it.
  SCARP_INLINE void put(double* out, const B& folded) const {
    if (out == nullptr) return;
    alignas(64) Real lane[lanes<Real, Arch>];
    folded.store_aligned(lane);
    for (int l = 0; l < half; ++l) out[first + l] = static_cast<double>(lane[l]);
  }
};

}  // namespace scarp::kernels
