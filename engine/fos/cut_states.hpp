// SPDX-License-Identifier: BSD-3-Clause
/// States on the way of a cut, at the ends of its levels: trials share their way down.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/fos/cut.hpp"
#include "engine/simulation.hpp"

namespace scarp {

struct CutState {
  std::vector<StageStrength> way;  ///< to here; empty: the settled state
  Simulation state;
  double displacement = 0.0;  ///< largest of the judged point so far [m]
};

/// Those that are kept; the oldest go where all take more than a gigabyte, but for one.
class CutStates {
 public:
  /// The longest way kept with which a cut by these stages begins; null: there is none.
  const CutState* deepest(const std::vector<Stage>& stages) const;
  void keep(std::vector<CutState> states);
  /// Away with states that no trial will begin from after one with these stages: those beyond a
  /// factor that fails, those before the last on the way to one that stands.
  void forget(const std::vector<Stage>& stages, bool fails);

 private:
  std::vector<CutState> states_;
};

/// How many such states there is memory for.
std::size_t most_cut_states(const Simulation& simulation);

}  // namespace scarp
