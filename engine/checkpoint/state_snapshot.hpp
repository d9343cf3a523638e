// SPDX-License-Identifier: BSD-3-Clause
/// A run's state as a snapshot, and back.
#pragma once

#include "engine/checkpoint/snapshot.hpp"

namespace scarp {

struct State;

/// Everything a bit-exact continuation needs between two steps; changes nothing.
Snapshot take_snapshot(const State& state);

/// Puts a snapshot into the state that `make_state` has made of the same scene; neighbour lists and
/// images are built again from the positions of their last build. Errors: CheckpointError, after
/// which `state` is to be thrown away.
void apply_snapshot(State& state, const Snapshot& snapshot);

}  // namespace scarp
