// SPDX-License-Identifier: BSD-3-Clause
/// Records of a run in mixed precision: those of `Records` in single precision, made before each
/// sweep, with positions as integers.
#pragma once

#include <cstdint>
#include <optional>

#include "engine/particles/aligned_vector.hpp"
#include "engine/particles/slot_ranges.hpp"
#include "kernels/particle_view.hpp"

namespace scarp {

class NarrowRecords {
 public:
  /// The view in single precision, its records copied from those of the soil in `which` and from
  /// records owned .. far_record; outputs stay double. Accuracy: positions to 2^-19 h, all else to
  /// 2^-24 of itself. Pre: afterwards `out_of_reach` has to be asked.
  kernels::PairSweepView<float> narrow(int threads, const kernels::PairSweepView<double>& view,
                                       std::int64_t far_record, std::int64_t owned = 0,
                                       const SlotRanges& which = {});
  /// The first record of the last call that was further from record 0 than positions reach, 2048 h,
  /// along an axis; none: the view may be used.
  std::optional<std::int64_t> out_of_reach() const { return out_of_reach_; }
  std::size_t bytes() const;

 private:
  AlignedVector<float> records_, second_, extra_;
  std::optional<std::int64_t> out_of_reach_;
};

}  // namespace scarp
