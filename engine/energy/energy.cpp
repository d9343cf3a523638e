// SPDX-License-Identifier: BSD-3-Clause
/// Energy balance of a stage: stored energies from the state, dissipated ones from sampled powers.
#include "engine/energy/energy.hpp"

#include <algorithm>
#include <array>

#include "engine/parallel.hpp"
#include "engine/particles/aligned_vector.hpp"
#include "engine/state.hpp"

namespace scarp {
namespace {

using kernels::SymTensor;

/// Powers are sampled every so many steps: each sample costs a force sweep, one more with
/// viscosity, one more once soil has been in tension, and where a wall moves those of
/// `wall_reactions`.
constexpr std::uint64_t steps_per_sample = 10;

/// Stored energies and per-mass work fields summed over the particles, and what hooks did;
/// `plastic` and `diffusion` since reset.
struct StoredEnergy {
  EnergyBalance parts;
  double stress_work = 0.0;

  void add(const StoredEnergy& more) {
    for (const auto part :
         {&EnergyBalance::kinetic, &EnergyBalance::kinetic_added, &EnergyBalance::potential,
          &EnergyBalance::elastic, &EnergyBalance::plastic, &EnergyBalance::diffusion})
      parts.*part += more.parts.*part;
    stress_work += more.stress_work;
  }
};

/// Of the particles begin .. end of a group.
StoredEnergy energy_of(const State& state, const ParticleGroup& group, std::int64_t begin,
                       std::int64_t end) {
  StoredEnergy sum;
  const ParticleBuffers& p = state.particles;
  const double mass = group.mass, inertia = group.inertia();
  const kernels::ElasticModuli moduli = state.scene.materials[group.material].model.moduli();
  for (std::int64_t k = begin; k < end; ++k) {
    const auto value = [&](Field field, int component) {
      const double* array = p.component(field, component);
      return array != nullptr ? array[k] : 0.0;
    };
    for (int a = 0; a < p.dimension(); ++a) {
      const double v = value(Field::velocity, a);
      sum.parts.kinetic += 0.5 * inertia * v * v;
      sum.parts.kinetic_added += 0.5 * (inertia - mass) * v * v;
      sum.parts.potential -=
          mass * state.scene.gravity[static_cast<std::size_t>(a)] * value(Field::position, a);
    }
    const SymTensor<double> s{value(Field::stress, 0), value(Field::stress, 1),
                              value(Field::stress, 2), value(Field::stress, 3),
                              value(Field::stress, 4), value(Field::stress, 5)};
    sum.parts.elastic +=
        0.5 * mass / value(Field::density, 0) * contract(s, kernels::elastic_strain(moduli, s));
    sum.parts.plastic += mass * value(Field::plastic_work, 0);
    sum.parts.diffusion += mass * value(Field::diffusion_work, 0);
    sum.stress_work += mass * value(Field::stress_work, 0);
  }
  return sum;
}

StoredEnergy own_energy(const State& state) {
  StoredEnergy sum;
  for (const ParticleGroup& group : state.particles.groups()) {
    sum.add(parallel_reduce(
        state.threads, group.count, particle_chunk, StoredEnergy{},
        [&](std::int64_t begin, std::int64_t end) {
          return energy_of(state, group, group.first + begin, group.first + end);
        },
        [](StoredEnergy& total, const StoredEnergy& part) { total.add(part); }));
  }
  sum.parts.hooks = state.ledger.hooks.net;
  sum.parts.sleep = state.sleep.kinetic;
  return sum;
}

/// Of the soil of all parts.
StoredEnergy stored_energy(const State& state) {
  StoredEnergy sum = own_energy(state);
  state.reduction->sum_each({&sum.parts.kinetic, &sum.parts.kinetic_added, &sum.parts.potential,
                             &sum.parts.elastic, &sum.parts.plastic, &sum.parts.diffusion,
                             &sum.parts.hooks, &sum.parts.sleep, &sum.stress_work});
  return sum;
}

/// sum m v . a over the soil of this part, m the inertia.
double power(const State& state, const double* const (&acceleration)[3]) {
  const double* velocity[3];
  state.particles.components(Field::velocity, velocity);
  double sum = 0.0;
  for (const ParticleGroup& group : state.particles.groups()) {
    sum += group.inertia() *
           parallel_reduce(
               state.threads, group.count, particle_chunk, 0.0,
               [&](std::int64_t begin, std::int64_t end) {
                 double part = 0.0;
                 for (int a = 0; a < state.scene.dimension; ++a) {
                   for (std::int64_t k = group.first + begin; k < group.first + end; ++k)
                     part += velocity[a][k] * acceleration[a][k];
                 }
                 return part;
               },
               [](double& total, double part) { total += part; });
  }
  return sum;
}

}  // namespace

void sample_energy(State& state) {
  EnergyLedger& ledger = state.ledger;
  if (!state.scene.output.energy || state.report.step < ledger.last_step + steps_per_sample) return;
  const double interval = state.report.time - ledger.last_time;
  ledger.last_time = state.report.time;
  ledger.last_step = state.report.step;

  RawVector<double> forces[3];
  const double* acceleration[3];
  kernels::PairSweepView<double> view = sweep_input_view(state);
  double** out = view.output + output_place(Field::acceleration);
  for (std::size_t a = 0; a < 3; ++a) {
    forces[a].resize(static_cast<std::size_t>(state.particles.slots()));
    acceleration[a] = out[a] = forces[a].data();
    parallel_chunks(state.threads, state.particles.slots(), particle_chunk,
                    [to = out[a]](std::int64_t begin, std::int64_t end) {
                      std::fill(to + begin, to + end, 0.0);
                    });
  }
  const auto power_of = [&](bool viscosity, bool tension) {
    kernels::PairConstants<double>& c = view.constants;
    if (!viscosity) c.viscosity_alpha = c.viscosity_beta = c.hourglass_viscosity = 0.0;
    state.sweep.records.fill(view, tension && state.sweep.records.has_second());
    sweep_force_with(state, awake_clusters(state), view, state.sweep.narrow_records);
    return power(state, acceleration);
  };
  const double total = power_of(true, true);
  const kernels::TermSet terms = state.kernels.terms;
  const bool dissipates =
      terms.has(kernels::Term::viscosity) || terms.has(kernels::Term::hourglass_viscosity);
  const double without_viscosity = dissipates ? power_of(false, true) : total;
  const double stress_only =
      state.sweep.records.has_second() ? power_of(false, false) : without_viscosity;
  ForcePowers now;
  now.viscous = without_viscosity - total;
  now.artificial_stress = stress_only - without_viscosity;
  now.stress = stress_only;
  const double* velocity[3];
  state.particles.components(Field::velocity, velocity);
  now.damping = state.stage.damping * power(state, velocity);
  state.reduction->sum_each({&now.stress, &now.viscous, &now.artificial_stress, &now.damping});
  if (std::any_of(state.boundary.velocity.begin(), state.boundary.velocity.end(),
                  [](const Vec3& v) { return v != Vec3{}; })) {
    const std::vector<WallReaction> reactions = wall_reactions(state);
    std::vector<Vec3> hold_force = state.boundary.hold_force;
    state.reduction->sum_each(hold_force);
    for (std::size_t w = 0; w < reactions.size(); ++w) {
      for (std::size_t a = 0; a < 3; ++a) {
        const double held = hold_force[w][a];
        now.wall += (reactions[w].force[a] - held) * state.boundary.velocity[w][a];
        now.hold += held * state.boundary.velocity[w][a];
      }
    }
  }
  const auto add = [&](double ForcePowers::*part) {
    ledger.work.*part += 0.5 * interval * (ledger.last_powers.*part + now.*part);
  };
  for (const auto part :
       {&ForcePowers::stress, &ForcePowers::viscous, &ForcePowers::artificial_stress,
        &ForcePowers::damping, &ForcePowers::wall, &ForcePowers::hold}) {
    add(part);
  }
  ledger.last_powers = now;
}

double mechanical_energy(const State& state) {
  const EnergyBalance own = own_energy(state).parts;
  return own.kinetic + own.potential + own.elastic;
}

EnergyBalance energy_balance(const State& state) {
  const EnergyLedger& ledger = state.ledger;
  const StoredEnergy now = stored_energy(state);
  EnergyBalance e;
  e.kinetic = now.parts.kinetic;
  e.kinetic_added = now.parts.kinetic_added;
  e.potential = now.parts.potential - ledger.start.potential;
  e.elastic = now.parts.elastic - ledger.start.elastic;
  e.plastic = now.parts.plastic - ledger.start.plastic;
  e.diffusion = now.parts.diffusion - ledger.start.diffusion;
  e.viscous = ledger.work.viscous;
  e.damping = ledger.work.damping;
  e.artificial_stress = ledger.work.artificial_stress;
  e.wall = ledger.work.wall + ledger.work.hold;
  e.hooks = now.parts.hooks;
  e.sleep = now.parts.sleep;
  if (state.scene.output.energy) {
    e.gradient_residue =
        -ledger.work.stress - (now.stress_work - ledger.stress_work_start) - ledger.work.wall;
    e.imbalance = e.hooks - (e.kinetic - ledger.start.kinetic + e.potential + e.elastic +
                             e.plastic + e.viscous + e.damping + e.wall + e.artificial_stress +
                             e.gradient_residue + e.diffusion + e.sleep);
  }
  return e;
}

void start_ledger(State& state) {
  const StoredEnergy now = stored_energy(state);
  state.ledger = EnergyLedger{};
  state.sleep.kinetic = 0.0;
  state.ledger.last_time = state.report.time;
  state.ledger.last_step = state.report.step;
  state.ledger.start = now.parts;
  state.ledger.stress_work_start = now.stress_work;
}

}  // namespace scarp
