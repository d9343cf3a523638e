// SPDX-License-Identifier: BSD-3-Clause
/// Runs the chosen pair sweep over clusters, in chunks.
#include "engine/sweep/pair_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <utility>

#include "engine/parallel.hpp"
#include "engine/state.hpp"
#include "engine/sweep/second_lines.hpp"
#include "engine/watch/watch.hpp"
#include "kernels/pair/term_rows.hpp"

namespace scarp {
namespace {

template <class Real>
void run(const State& state, kernels::PairSweep<Real> sweep, std::int64_t clusters,
         const kernels::PairSweepView<Real>& view) {
  const std::int64_t chunk = particle_chunk / state.kernels.cluster_size;
  parallel_chunks(state.threads, clusters, chunk,
                  [&](std::int64_t begin, std::int64_t end) { sweep(view, begin, end); });
}

/// Soil that has flown further than positions of mixed precision reach; `record` may be an image or
/// a wall's, whose own place is then named.
Instability flown_out_of_reach(const State& state, const double* records, std::int64_t record) {
  const double h = state.smoothing_length;
  const bool soil = record < state.sweep.records.layout()[Role::owned].end();
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

/// `soil` is what may be read of it: soil that sleeps and is no neighbour of the swept clusters may
/// be left as it is. So may dummies that no soil reaches, and without `inner` all inner points.
RecordsRead records_read(const State& state, SlotRanges soil, bool inner) {
  const RecordLayout& layout = state.sweep.records.layout();
  const int size = state.kernels.table->cluster_size;
  auto clusters = state.neighbours.wall_lists.active_clusters();
  if (!inner) {
    const auto end = std::lower_bound(clusters.begin(), clusters.end(),
                                      state.boundary.walls.dummy_slots() / size);
    clusters = clusters.first(static_cast<std::size_t>(end - clusters.begin()));
  }
  return {layout[Role::owned].slots, std::move(soil),
          layout[Role::dummy].slots + layout[Role::inner].slots, clusters, size};
}

void run(const State& state, const SweepKernel& sweep, std::span<const std::int32_t> clusters,
         const RecordsRead& read, kernels::PairSweepView<double> view,
         NarrowRecords& narrow_records) {
  view.clusters = clusters.data();
  if (sweep.mixed == nullptr) {
    run(state, sweep.in_double, std::ssize(clusters), view);
    return;
  }
  const std::int64_t far_record = state.sweep.records.layout().far_record();
  const kernels::PairSweepView<float> narrow =
      narrow_records.narrow(state.threads, view, far_record, read);
  if (const auto record = narrow_records.out_of_reach())
    throw SimulationInstability(flown_out_of_reach(state, view.records, *record));
  run(state, sweep.mixed, std::ssize(clusters), narrow);
}

/// The sweep of forces divides by inertia, and viscosity is that of the inertia of both of a pair;
/// what came before it took weights and masses from the density.
void put_inertia(State& state) {
  Records& records = state.sweep.records;
  records.put_inertia(state.threads, Role::owned, state.particles, soil_packed(state));
  records.put_inertia(state.threads, Role::ghost, state.ghosts);
  state.boundary.images.copy_density(state.threads, records, images_packed(state));
  const Material& of_walls = state.scene.materials[state.boundary.material];
  state.boundary.walls.put_density(state.threads, records,
                                   of_walls.mass_scaling * of_walls.density);
}

/// Second lines are packed just before the terms that read them are summed; while all are zero, the
/// sweep without these terms runs.
void run_force_sweep(State& state, const ChosenSweep& sweep) {
  if (state.scaling.scales_mass) put_inertia(state);
  kernels::PairSweepView<double> view = sweep_view(state);
  Records& records = state.sweep.records;
  const bool marked =
      pack_second_lines(state.threads, {state.particles, state.ghosts}, state.kernels, records);
  if (records.has_second())
    state.boundary.images.pack_second(state.threads, records, state.kernels.terms,
                                      state.scene.dimension);
  records.fill(view, marked);
  run(state, marked ? sweep.whole : sweep.unmarked, swept_clusters(state),
      records_read(state, soil_read(state), false), view, state.sweep.narrow_records);
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
  for (const kernels::TermRow& row : kernels::term_rows) {
    double** out = view.output + row.first_output;
    for (const kernels::FieldUse& use : row.writes) {
      for (int c = 0; c < use.components; ++c) *out++ = state.particles.component(field_of(use), c);
    }
  }
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
  p.components(Field::force_moment, view.force_moment);
  p.components(Field::strain_rate, view.strain_rate);
  const ParticleBuffers& rates = p;
  view.density_rate = rates.component(Field::density_rate);
  rates.components(Field::velocity_gradient, view.velocity_gradient);
  rates.components(Field::moment, view.moment);
  rates.components(Field::acceleration, view.acceleration);
  rates.components(Field::diffusion_rate, view.diffusion_rate);
  view.diffusion_slope = rates.component(Field::diffusion_slope);
  return view;
}

/// Verlet takes the rates of soil that wakes in this very step.
void sweep_gradient(State& state) {
  const bool verlet = state.scene.numerics.integrator == Integrator::verlet;
  run(state, state.kernels.gradient.whole, verlet ? swept_clusters(state) : awake_clusters(state),
      records_read(state, soil_read(state), true), sweep_view(state), state.sweep.narrow_records);
}
void sweep_force(State& state) { run_force_sweep(state, state.kernels.force); }
void sweep_all(State& state) {
  if (state.kernels.fused.whole) {
    run_force_sweep(state, state.kernels.fused);
  } else {
    sweep_gradient(state);
    sweep_force(state);
  }
}

void sweep_force_with(const State& state, std::span<const std::int32_t> clusters,
                      const kernels::PairSweepView<double>& view, NarrowRecords& narrow) {
  run(state, state.kernels.force.whole, clusters, records_read(state, SlotRanges(), false), view,
      narrow);
}

}  // namespace scarp
