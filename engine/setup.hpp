// SPDX-License-Identifier: BSD-3-Clause
/// Set-up of a run: a scene becomes a state.
#pragma once

#include "engine/particles/particles.hpp"
#include "engine/run_options.hpp"
#include "engine/scene/scene.hpp"
#include "engine/state.hpp"
#include "kernels/isa/kernel_table.hpp"

namespace scarp {

/// The soil is that of the scene's bodies, or `particles`.
State make_state(Scene scene, const RunOptions& options, const Particles* particles = nullptr);
/// The threads of a run. Errors: SceneError for fewer than one or more than there are cores.
Team make_team(const RunOptions& options);
/// All soil has been made: from here on this is the part of it that the reduction leaves.
void take_part(State& state);
void set_material_constants(State& state);  ///< for the strength reduction of the current stage
/// Of one material; the step's own, `leap` and `plastic_share`, and the group's smoothing length
/// stay 0.
kernels::StressPassConstants stress_pass_constants(const Scene& scene, const Material& material,
                                                   double strength_reduction);
/// The instruction set asked for, else the best. Errors: SceneError.
const kernels::KernelTable& choose_table(const RunOptions& options);

}  // namespace scarp
