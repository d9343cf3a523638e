// SPDX-License-Identifier: BSD-3-Clause
/// Pair sweeps of a run: which were chosen, what they read, the phases that run them.
#pragma once

#include <cstdint>
#include <span>

#include "engine/step/phase.hpp"
#include "engine/sweep/chosen_kernels.hpp"
#include "engine/sweep/narrow_records.hpp"
#include "engine/sweep/records.hpp"
#include "kernels/isa/kernel_table.hpp"

namespace scarp {

struct State;

/// What the sweeps read besides the lists.
struct SweepInput {
  Records records;
  NarrowRecords narrow_records;  ///< of a run in mixed precision
  kernels::PairConstants<double> constants{};
};

void sweep_all(State& state);       ///< Verlet: every rate at once
void sweep_gradient(State& state);  ///< kick-drift-kick: velocity gradient, diffusion
void sweep_force(State& state);     ///< kick-drift-kick: acceleration

/// Records, lists and constants of the step, no output.
kernels::PairSweepView<double> sweep_input_view(const State& state);
/// ... with the outputs of the step.
kernels::PairSweepView<double> sweep_view(State& state);
/// ... for the passes of a model.
kernels::ParticleView particle_view(State& state, const kernels::ModelInfo& model);
/// Force sweep of these clusters with other records, constants or outputs than the step's own
/// (reactions, energies). `narrow` is where mixed precision puts its records.
void sweep_force_with(const State& state, std::span<const std::int32_t> clusters,
                      const kernels::PairSweepView<double>& view, NarrowRecords& narrow);

namespace phases {

/// Where soil is in tension a sweep of forces packs second lines of the records.
inline constexpr DataSet force_input{Field::density, Field::stress, Field::force_moment,
                                     Part::records, Part::lists};
inline constexpr DataSet force_output{Field::acceleration, Field::approach_rate, Part::records};
inline constexpr DataSet gradient_output{Field::density_rate, Field::velocity_gradient,
                                         Field::moment, Field::diffusion_rate,
                                         Field::diffusion_slope};
inline constexpr Phase sweep_all{"sweep_all", force_input, force_output | gradient_output,
                                 scarp::sweep_all};
inline constexpr Phase sweep_gradient{
    "sweep_gradient", {Part::records, Part::lists}, gradient_output, scarp::sweep_gradient};
inline constexpr Phase sweep_force{"sweep_force", force_input, force_output, scarp::sweep_force};

}  // namespace phases

}  // namespace scarp
