// SPDX-License-Identifier: BSD-3-Clause
/// Trials of a search side by side, where one alone cannot use all threads.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/fos/strength_reduction.hpp"

namespace scarp {

/// While one trial runs, the two that may be asked for next, whether it stands or fails, begin in
/// other threads. They are used only if they are asked for then, so a search gives the same, bit
/// for bit, with and without. Where three trials cannot make use of all threads; with one trial
/// ahead, half of them in vain, searches took 0.8 to 1.15 of the time, which is why there are two.
class SideBySide {
 public:
  explicit SideBySide(StrengthReduction& slope);
  ~SideBySide();
  SideBySide(const SideBySide&) = delete;
  SideBySide& operator=(const SideBySide&) = delete;

  /// `StrengthReduction::respond`, and `next` begin beside it. `proceed` is called from one thread
  /// at a time, not always from this one. Errors: those of `respond`; Stopped.
  std::optional<Trial> respond(double reduction, const std::vector<double>& next,
                               const Proceed& proceed);

 private:
  struct Ahead;
  std::unique_ptr<Ahead> begin(double reduction) const;

  void look_ahead(const std::vector<double>& next);

  StrengthReduction& slope_;
  int team_;        ///< threads of each trial
  int beside_ = 0;  ///< trials beside the one at hand, at most
  std::vector<std::unique_ptr<Ahead>> ahead_;
};

}  // namespace scarp
