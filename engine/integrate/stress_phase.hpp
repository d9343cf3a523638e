// SPDX-License-Identifier: BSD-3-Clause
/// Runs a per-particle pass group by group, each with its material's constants and model.
#pragma once

#include <algorithm>

#include "engine/particles/each_slot.hpp"
#include "engine/state.hpp"
#include "kernels/constitutive/model_info.hpp"

namespace scarp {

/// pass(passes of the model, view, constants, begin, end) returns how often the density bounds
/// acted.
template <class Pass>
void run_stress_phase(State& state, double dt, double leap, Pass&& pass) {
  for (std::size_t index = 0; index < state.particles.groups().size(); ++index) {
    const ParticleGroup& group = state.particles.groups()[index];
    kernels::StressPassConstants constants = state.material_constants[group.material];
    constants.leap = leap;
    constants.plastic_share = dt / leap;
    constants.smoothing_length = group.smoothing_length;
    const Vec3 fall = group.fall(state.scene.gravity);
    std::copy(fall.begin(), fall.end(), constants.gravity);
    const kernels::ModelInfo& model = state.scene.materials[group.material].model.info();
    const kernels::ModelPasses& passes = state.kernels.table->passes_of(model);
    const kernels::ParticleView view = particle_view(state, model);
    state.density_bounds += reduce_slots(
        state.threads, state.sleep.awake, group, index, group.padded_end(), std::uint64_t{0},
        [&](std::int64_t begin, std::int64_t end) {
          return pass(passes, view, constants, static_cast<std::size_t>(begin),
                      static_cast<std::size_t>(end));
        },
        [](std::uint64_t& total, std::uint64_t part) { total += part; });
  }
}

}  // namespace scarp
