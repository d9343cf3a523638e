// SPDX-License-Identifier: BSD-3-Clause
/// Which states are kept, and which of them a cut begins from.
#include "engine/fos/cut_states.hpp"

#include <algorithm>

namespace scarp {

std::size_t most_cut_states(const Simulation& simulation) {
  constexpr std::size_t memory = std::size_t{1} << 30;  // [bytes]
  return std::max<std::size_t>(1, memory / simulation.memory_bytes());
}

const CutState* CutStates::deepest(const std::vector<Stage>& stages) const {
  const CutState* deepest = nullptr;
  for (const CutState& kept : states_) {
    const bool begins = kept.way.size() < stages.size() &&
                        std::equal(kept.way.begin(), kept.way.end(), stages.begin(),
                                   [](const StageStrength& strength, const Stage& stage) {
                                     return strength == strength_of(stage);
                                   });
    if (begins && (deepest == nullptr || kept.way.size() > deepest->way.size())) deepest = &kept;
  }
  return deepest;
}

void CutStates::keep(std::vector<CutState> states) {
  for (CutState& state : states) {
    const auto same = [&state](const CutState& kept) { return kept.way == state.way; };
    if (std::any_of(states_.begin(), states_.end(), same)) continue;
    if (states_.size() >= most_cut_states(state.state)) states_.erase(states_.begin());
    states_.push_back(std::move(state));
  }
}

void CutStates::forget(const std::vector<Stage>& stages, bool fails) {
  const auto shared = [&stages](const CutState& kept) {
    return kept.way.size() < stages.size() &&
           kept.way.back() == strength_of(stages[kept.way.size() - 1]);
  };
  const CutState* last = fails ? nullptr : deepest(stages);
  const std::size_t length = last == nullptr ? 0 : last->way.size();
  std::erase_if(states_, [&](const CutState& kept) {
    return fails ? !shared(kept) : shared(kept) && kept.way.size() < length;
  });
}

}  // namespace scarp
