// SPDX-License-Identifier: BSD-3-Clause
/// Records of a run in mixed precision: those of `Records` in single precision, made before each
/// sweep, with positions as integers.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/particles/aligned_vector.hpp"
#include "engine/particles/slot_ranges.hpp"
#include "kernels/particle_view.hpp"

namespace scarp {

/// Which records a sweep reads; by default all.
struct RecordsRead {
  std::int64_t owned = 0;                        ///< how many of soil come first
  SlotRanges soil;                               ///< those of them that are read
  std::int64_t dummies = 0;                      ///< how many of walls come next
  std::span<const std::int32_t> dummy_clusters;  ///< those of them that are read
  std::int64_t dummy_cluster_size = 1;
};

class NarrowRecords {
 public:
  /// The view in single precision, with copies of the records that are read; outputs stay double.
  /// Accuracy: positions to 2^-19 h, all else to 2^-24 of itself. Pre: afterwards `out_of_reach`
  /// has to be asked.
  kernels::PairSweepView<float> narrow(int threads, const kernels::PairSweepView<double>& view,
                                       std::int64_t far_record, const RecordsRead& read = {});
  /// The first record read in the last call that was further from record 0 than positions reach,
  /// 2048 h, along an axis; none: the view may be used.
  std::optional<std::int64_t> out_of_reach() const { return out_of_reach_; }
  std::size_t bytes() const;

 private:
  AlignedVector<float> records_, second_, extra_;
  std::optional<std::int64_t> out_of_reach_;
};

}  // namespace scarp
