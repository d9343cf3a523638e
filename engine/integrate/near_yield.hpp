// SPDX-License-Identifier: BSD-3-Clause
/// Step limiter of the rate forms: their stress must not overshoot the yield surface far.
#pragma once

#include "engine/state.hpp"

namespace scarp {

/// Shortest time within `dt` at which a particle that is still elastic would meet the yield surface
/// by its elastic rate, but at least a tenth of `dt`. Equation: L1 (the paper names such a
/// technique without its formula). Reads the last velocity gradient swept: with kick-drift-kick
/// that of the middle of the step before. Limits: ignores rotation and diffusion.
double time_to_first_yield(State& state, double dt);

}  // namespace scarp
