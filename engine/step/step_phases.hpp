// SPDX-License-Identifier: BSD-3-Clause
/// The phases of each integrator in their order.
#pragma once

#include "engine/scene/scene.hpp"
#include "engine/step/phase.hpp"

namespace scarp {

/// `stage_start` runs before the first step of a stage, `step` in every step; `renewal` where the
/// state was changed between two steps: what a step takes over from the one before is made anew.
struct StepPhases {
  PhaseList stage_start, step, renewal;
};
StepPhases phases_of(Integrator integrator, bool corrects_forces);

}  // namespace scarp
