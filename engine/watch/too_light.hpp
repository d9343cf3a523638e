// SPDX-License-Identifier: BSD-3-Clause
/// Soil that has come too near to soil of more inertia.
#pragma once

namespace scarp {

struct State;

/// Whether a particle has less than a quarter of the inertia that its present neighbours ask of it
/// (`shared_inertia`), so that the step is twice too long for it; where inertia is scaled, before
/// lists are built anew. Errors: SimulationInstability. Limits: neighbours of other parts of the
/// soil are not seen.
void watch_inertia(const State& state);

}  // namespace scarp
