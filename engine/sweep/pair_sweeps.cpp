// SPDX-License-Identifier: BSD-3-Clause
/// Runs the chosen pair sweep over all clusters, in chunks.
#include "engine/sweep/pair_sweeps.hpp"

#include <cmath>
#include <cstdlib>

#include "engine/parallel.hpp"
#include "engine/state.hpp"
#include "engine/watch/watch.hpp"

namespace scarp {
namespace {

template <class Real>
void run(const State& state, kernels::PairSweep<Real> sweep,
         const kernels::PairSweepView<Real>& view) {
  const std::int64_t chunk = particle_chunk / state.kernels.cluster_size;
  parallel_chunks(state.threads, state.neighbours.lists.clusters(), chunk,
                  [&](std::int64_t begin, std::int64_t end) { sweep(view, begin, end); });
}

/// Soil that has flown further than positions of mixed precision reach; `record` may be an image or
/// a wall's, whose own place is then named.
Instability flown_out_of_reach(const State& state, const double* records, std::int64_t record) {
  const double h = state.smoothing_length;
  const bool soil = record < state.particles.slots();
  Instability found = at_particle(state, soil ? record : 0);
  if (!soil) found.particle = -1;
  double furthest = 0.0;
  for (int a = 0; a < 3; ++a) {
    const double place = records[record * kernels::record_size + kernels::record_x + a] * h;
    found.position[static_cast<std::size_t>(a)] = place;
    furthest = std::max(furthest, std::abs(place - records[kernels::record_x + a] * h));
  }
  found.field = "distance from other soil";
  found.unit = "m";
  found.value = furthest;
  found.limit = kernels::position_reach * h;
  found.cause = "grains that fly or fall away: positions of mixed precision reach no further";
  found.advice = "precision = \"double\", or walls that hold the soil";
  return found;
}

void run(const State& state, const ChosenSweep& sweep, const kernels::PairSweepView<double>& view,
         NarrowRecords& narrow_records) {
  if (sweep.mixed == nullptr) {
    run(state, sweep.in_double, view);
    return;
  }
  const kernels::PairSweepView<float> narrow =
      narrow_records.narrow(state.threads, view, state.sweep.records.far_record());
  if (const auto record = narrow_records.out_of_reach())
    throw SimulationInstability(flown_out_of_reach(state, view.records, *record));
  run(state, sweep.mixed, narrow);
}

/// Tension records are only needed where a force is summed; while nothing is in tension the sweep
/// without the artificial stress runs.
void run_force_sweep(State& state, const ChosenSweep& sweep, const ChosenSweep& in_compression) {
  kernels::PairSweepView<double> view = sweep_view(state);
  bool tension = false;
  if (state.kernels.artificial_stress) {
    tension = state.sweep.records.pack_tension(state.threads, state.particles,
                                               state.scene.numerics.artificial_stress);
    if (state.sweep.records.has_tension_records())
      state.boundary.images.pack_tension(state.sweep.records);
    state.sweep.records.fill(view, tension);
  }
  run(state, tension ? sweep : in_compression, view, state.sweep.narrow_records);
}

}  // namespace

kernels::PairSweepView<double> sweep_input_view(const State& state) {
  kernels::PairSweepView<double> view{};
  state.sweep.records.fill(view, false);
  view.neighbours = state.neighbours.lists.view();
  view.constants = state.sweep.constants;
  view.smoothing_length = state.smoothing_length;
  return view;
}

kernels::PairSweepView<double> sweep_view(State& state) {
  kernels::PairSweepView<double> view = sweep_input_view(state);
  ParticleBuffers& p = state.particles;
  view.density_rate = p.component(Field::density_rate);
  p.components(Field::velocity_gradient, view.velocity_gradient);
  p.components(Field::moment, view.moment);
  p.components(Field::acceleration, view.acceleration);
  view.approach_rate = p.component(Field::approach_rate);
  p.components(Field::diffusion_rate, view.diffusion_rate);
  view.diffusion_slope = p.component(Field::diffusion_slope);
  return view;
}

kernels::ParticleView particle_view(State& state, const kernels::ModelInfo& model) {
  ParticleBuffers& p = state.particles;
  kernels::ParticleView view{};
  p.components(Field::position, view.position);
  p.components(Field::velocity, view.velocity);
  view.density = p.component(Field::density);
  p.components(Field::stress, view.stress);
  p.components(Field::previous_velocity, view.previous_velocity);
  view.previous_density = p.component(Field::previous_density);
  p.components(Field::previous_stress, view.previous_stress);
  for (std::size_t h = 0; h < model.state_fields.size(); ++h)
    view.history[h] = p.declared(model.state_fields[h].name);
  view.stress_work = p.component(Field::stress_work);
  view.plastic_work = p.component(Field::plastic_work);
  view.diffusion_work = p.component(Field::diffusion_work);
  view.diffusivity = p.component(Field::diffusivity);
  const ParticleBuffers& rates = p;
  view.density_rate = rates.component(Field::density_rate);
  rates.components(Field::velocity_gradient, view.velocity_gradient);
  rates.components(Field::moment, view.moment);
  rates.components(Field::acceleration, view.acceleration);
  rates.components(Field::diffusion_rate, view.diffusion_rate);
  view.diffusion_slope = rates.component(Field::diffusion_slope);
  return view;
}

void sweep_all(State& state) {
  run_force_sweep(state, state.kernels.fused, state.kernels.fused_in_compression);
}
void sweep_gradient(State& state) {
  run(state, state.kernels.gradient, sweep_view(state), state.sweep.narrow_records);
}
void sweep_force(State& state) {
  run_force_sweep(state, state.kernels.force, state.kernels.force_in_compression);
}

void sweep_force_with(const State& state, const kernels::PairSweepView<double>& view,
                      NarrowRecords& narrow) {
  run(state, state.kernels.force, view, narrow);
}

}  // namespace scarp
