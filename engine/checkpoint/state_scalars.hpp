// SPDX-License-Identifier: BSD-3-Clause
/// Single numbers of a state: clocks, counts, energies.
#pragma once

#include "engine/checkpoint/snapshot.hpp"

namespace scarp {

struct State;

void take_scalars(Snapshot& out, const State& state);
/// Errors: CheckpointError for a number that no run leaves.
void put_scalars(const Snapshot& from, State& state);

}  // namespace scarp
