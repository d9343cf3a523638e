// SPDX-License-Identifier: BSD-3-Clause
/// What a stored state must be like to be believed.
#pragma once

#include <string>

#include "engine/checkpoint/snapshot.hpp"

namespace scarp {

struct State;

/// Positions under `item` are within ten thousand sizes of the soil, as `make_state` placed it in
/// `state`: farther out they would be a matter for the cells' memory. Errors: CheckpointError.
void require_near(const Snapshot& from, const std::string& item, const State& state);

/// Of a state that has been put back: checkpoints are written of sound states only. Errors:
/// CheckpointError.
void require_sound(const State& state);

}  // namespace scarp
