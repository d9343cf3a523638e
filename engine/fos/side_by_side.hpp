// SPDX-License-Identifier: BSD-3-Clause
/// Trials of a search side by side, where one alone cannot use all threads.
#pragma once

#include <memory>
#include <optional>

#include "engine/fos/strength_reduction.hpp"

namespace scarp {

/// While one trial runs, the one that will most likely be asked for next begins in another thread.
/// It is used only if it is asked for then, so a search gives the same, bit for bit, with and
/// without. Where a trial makes use of more than half of the threads, trials run one by one.
class SideBySide {
 public:
  explicit SideBySide(StrengthReduction& slope);
  ~SideBySide();
  SideBySide(const SideBySide&) = delete;
  SideBySide& operator=(const SideBySide&) = delete;

  /// `StrengthReduction::respond`, and `next` begins beside it. `proceed` is called from one thread
  /// at a time, not always from this one. Errors: those of `respond`; Stopped.
  std::optional<Trial> respond(double reduction, std::optional<double> next,
                               const Proceed& proceed);

 private:
  struct Ahead;
  std::unique_ptr<Ahead> begin(double reduction) const;

  StrengthReduction& slope_;
  std::optional<int> half_team_;  ///< threads of each of two trials; empty: one by one
  std::unique_ptr<Ahead> ahead_;
};

}  // namespace scarp
