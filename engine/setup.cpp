// SPDX-License-Identifier: BSD-3-Clause
/// Turns a scene into the state of a run: what it uses is chosen here, once.
#include "engine/setup.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "engine/boundary/wall_joints.hpp"
#include "engine/errors.hpp"
#include "engine/initial_soil.hpp"
#include "engine/integrate/lattice_sums.hpp"
#include "engine/parallel.hpp"
#include "engine/particles/probe_particles.hpp"
#include "engine/particles/shared_inertia.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "engine/stop.hpp"
#include "kernels/smoothing/list.hpp"

namespace scarp {
namespace {

bool any_yields(const Scene& scene) {
  return std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const Material& material) { return material.model.yields(); });
}

std::vector<Field> used_fields(const Scene& scene, const ChosenKernels& chosen) {
  std::vector<Field> used(fields_of_every_run.begin(), fields_of_every_run.end());
  const auto add = [&used](bool wanted, std::initializer_list<Field> fields) {
    if (wanted) used.insert(used.end(), fields);
  };
  const std::vector<Field> of_terms = fields_of(chosen.terms);
  used.insert(used.end(), of_terms.begin(), of_terms.end());
  const bool energy = scene.output.energy;
  add(scene.numerics.integrator == Integrator::verlet,
      {Field::previous_velocity, Field::previous_density, Field::previous_stress});
  add(soil_may_sleep(scene),
      {Field::asleep, Field::stirred_time, Field::rest_acceleration, Field::rest_change});
  add(soil_may_sleep(scene) && !history_of(scene).empty(), {Field::stirred_history});
  add(energy, {Field::stress_work});
  add(energy && any_yields(scene), {Field::plastic_work});
  add(energy && chosen.terms.has(kernels::Term::diffusion), {Field::diffusion_work});
  return used;
}

/// Rows of the history variables of the scene's models.
std::vector<FieldRow> history_rows(const Scene& scene) {
  std::vector<FieldRow> rows;
  for (const kernels::StateField& field : history_of(scene)) {
    rows.push_back({declared_field(rows.size()),
                    field.name,
                    field.unit,
                    Rank::scalar,
                    Lifetime::state,
                    {Initial::From::value, field.initial_value},
                    field.reset_at_stage ? Reset::reset : Reset::kept,
                    Ghost::own,
                    Check::unchecked,
                    field.output ? Readout::real : Readout::inside,
                    field.description});
  }
  return rows;
}

/// Under a pressure along gravity, with K0 of it across: xx, yy, zz, xy, yz, zx.
std::array<double, 6> geostatic_stress(double pressure, double k0, const Vec3& up) {
  std::array<double, 6> stress{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3;
    stress[a] = -pressure * (k0 + (1.0 - k0) * up[a] * up[a]);
    if (up[a] * up[b] != 0.0) stress[a + 3] = -pressure * (1.0 - k0) * up[a] * up[b];
  }
  return stress;
}

/// The particles of a material with this inertia over mass, on the scene's lattice.
ParticleKind kind_of(const Scene& scene, std::size_t material, double mass_scaling) {
  const double volume = std::pow(scene.spacing, scene.dimension);
  const Material& of = scene.materials[material];
  return {material, of.density,          scene.spacing, smoothing_length_of(scene),
          volume,   of.density * volume, mass_scaling};
}

void fill_particles(State& state, const InitialSoil& initial) {
  const Scene& scene = state.scene;
  const Particles& soil = initial.particles;
  const std::vector<SoilAbove>& above = initial.above;
  const int dimension = scene.dimension;
  std::vector<ParticleGroup> groups;
  std::int64_t first = 0;
  const std::vector<double> inertia = shared_inertia(scene, soil);
  std::map<std::pair<std::size_t, double>, std::int64_t> counts;
  for (std::size_t k = 0; k < inertia.size(); ++k) ++counts[{soil.material[k], inertia[k]}];
  for (const auto& [kind, count] : counts) {
    groups.push_back({kind_of(scene, kind.first, kind.second), first, count, padded(count)});
    first += padded(count);
  }
  state.particles =
      ParticleBuffers(dimension, groups, used_fields(scene, state.kernels), history_rows(scene));
  ParticleBuffers& p = state.particles;
  state.start_is_geostatic = !above.empty();
  const Vec3 up = upward(scene);
  for (const ParticleGroup& group : groups) {
    const double k0 = state.material_constants[group.material].k0;
    std::int64_t slot = group.first;
    for (std::size_t k = 0; k < soil.position.size(); ++k) {
      if (soil.material[k] != group.material || inertia[k] != group.mass_scaling) continue;
      p.ids()[static_cast<std::size_t>(slot)] = soil.id[k];
      for (int a = 0; a < dimension; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        p.component(Field::position, a)[slot] = soil.position[k][axis];
        p.component(Field::velocity, a)[slot] = soil.velocity[k][axis];
      }
      std::array<double, 6> stress{};
      if (scene.initial_stress == InitialStress::uniform) stress = scene.uniform_stress;
      if (!soil.stress.empty()) stress = soil.stress[k];
      if (!above.empty()) stress = geostatic_stress(above[k].pressure, k0, up);
      for (int c = 0; c < (dimension == 2 ? 4 : 6); ++c)
        p.component(Field::stress, c)[slot] = stress[static_cast<std::size_t>(c)];
      if (!soil.density.empty()) {
        for (const Field field : {Field::density, Field::previous_density}) {
          if (p.has(field)) p.component(field)[slot] = soil.density[k];
        }
      }
      ++slot;
    }
  }
  p.start_from_here();
}

/// What the whole soil decides, of all its parts.
void look_at_all_soil(State& state) {
  std::vector<double> counts(state.scene.materials.size());
  double& fastest = state.limits.sound_speed;
  for (const ParticleGroup& group : state.particles.groups()) {
    counts[group.material] += static_cast<double>(group.count);
    fastest = std::max(fastest, state.scene.materials[group.material].sound_speed());
  }
  fastest = state.reduction->maximum_of(fastest);
  state.reduction->sum(counts);
  state.boundary.material =
      static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

void set_pair_constants(State& state) {
  const Numerics& n = state.scene.numerics;
  const kernels::SmoothingForm& form = smoothing_of(state.scene);
  kernels::PairConstants<double>& c = state.sweep.constants;
  for (int k = 0; k < 3; ++k) {
    c.smoothing.derivative[k] = form.derivative(k);
    c.smoothing.value[k] = form.value[k];
  }
  c.smoothing.derivative_inner = form.derivative(3);
  c.smoothing.value_inner = form.value_inner;
  c.viscosity_alpha = n.viscosity_alpha;
  c.viscosity_beta = n.viscosity_beta;
  c.hourglass_viscosity = n.hourglass_viscosity;
  for (std::size_t a = 0; a < 3; ++a)
    c.gravity[a] = state.scene.gravity[a] * state.smoothing_length;
  if (state.kernels.terms.has(kernels::Term::artificial_stress))
    c.tension_factor = tension_factor_of(state.scene).factor;
}

}  // namespace

kernels::StressPassConstants stress_pass_constants(const Scene& scene, const Material& material,
                                                   double strength_reduction) {
  const Numerics& n = scene.numerics;
  kernels::StressPassConstants c{};
  c.model = material.model.prepare({strength_reduction, scene.spacing, material.density});
  c.reference_density = material.density;
  c.density_minimum = n.density_minimum * material.density;
  c.density_maximum = n.density_maximum * material.density;
  // The pass knows no inertia: what it takes for the speed of sound is that of the mass.
  c.diffusion_cap =
      material.model.yields() ? n.stress_diffusion / std::sqrt(material.mass_scaling) : 0.0;
  c.diffusion_shear_gate = n.diffusion_shear_gate;
  std::copy(scene.gravity.begin(), scene.gravity.end(), c.gravity);
  c.k0 = k0_of(scene, material);
  c.gradient_correction = n.gradient_correction;
  c.hughes_winget = n.stress_rotation == StressRotation::hughes_winget;
  return c;
}

void set_material_constants(State& state) {
  const Stage& stage = state.scene.stages[state.stage.index];
  state.material_constants.clear();
  for (const Material& material : state.scene.materials) {
    state.material_constants.push_back(
        stress_pass_constants(state.scene, material, reduction_of(stage, material)));
  }
}

void place_walls(State& state) {
  const double cell = 0.5 * (2.0 + state.scene.numerics.skin) * state.smoothing_length;
  WallDummies moved = state.boundary.dummies;
  for (std::size_t k = 0; k < moved.position.size(); ++k) {
    for (std::size_t a = 0; a < 3; ++a)
      moved.position[k][a] += state.boundary.offset[moved.wall[k]][a];
  }
  state.boundary.walls =
      Walls(moved, state.boundary.stands, cell, state.scaling.inverse_smoothing_length,
            state.particles.largest_spacing());
  state.boundary.placed_offset = state.boundary.built_offset = state.boundary.offset;
  state.sweep.records = Records(state.particles.slots(), state.boundary.walls.dummy_slots(),
                                state.boundary.walls.inner_slots());
  state.neighbours.valid = false;
}

/// Tests ask for more threads than there are cores, to see that results do not depend on them.
Team make_team(const RunOptions& options) {
  constexpr int most_oversubscribed = 16;
  if (!options.threads) return {default_threads(), false};
  const int wanted = *options.threads;
  const bool checked = !options.oversubscribe || wanted < 1 || wanted > most_oversubscribed;
  const std::string complaint = checked ? complaint_about_threads(wanted) : "";
  if (!complaint.empty()) throw SceneError(complaint);
  return {wanted, true};
}

State make_state(Scene scene, const RunOptions& options, const Particles* particles) {
  validate(scene, particles == nullptr);
  State state;
  state.scene = std::move(scene);
  close_narrow_gaps(state.scene);
  state.options = options;
  if (options.reduction) state.reduction = options.reduction;
  state.team = make_team(options);
  state.threads = state.team.threads();
  const Numerics& n = state.scene.numerics;
  const int dimension = state.scene.dimension;
  state.kernels = choose_kernels(state.scene, any_yields(state.scene), choose_table(options));
  state.smoothing_length = smoothing_length_of(state.scene);
  const LatticeSums sums =
      lattice_sums(smoothing_of(state.scene), smoothing_ratio_of(state.scene), dimension);
  state.lattice_moment = sums.moment;
  state.limits.acoustic_cfl = acoustic_cfl_limit(n, sums);
  state.limits.damping_rates = damping_rates(n, sums, state.kernels.settings);
  state.scaling.inverse_smoothing_length = 1.0 / state.smoothing_length;
  state.scaling.gradient_factor = smoothing_of(state.scene).normalisation(dimension) /
                                  std::pow(state.smoothing_length, dimension + 1) /
                                  (n.lattice_normalisation ? state.lattice_moment : 1.0);
  set_material_constants(state);
  for (const Material& material : state.scene.materials) {
    state.scaling.wave_modulus.push_back(material.model.moduli().wave_modulus() /
                                         material.mass_scaling);
  }
  state.scaling.scales_mass = scales_mass(state.scene);
  if (state.kernels.terms.has(kernels::Term::diffusion))
    state.scaling.alike = first_alike(state.scene.materials);
  set_pair_constants(state);
  InitialSoil initial = drawn_soil(state, particles);
  state.boundary.surface = WallSurface(state.scene);
  state.boundary.dummies = generate_dummies(state.scene, state.options.stop);
  state.boundary.offset.assign(state.scene.walls.size(), Vec3{});
  state.boundary.stands.assign(state.scene.walls.size(), true);
  state.boundary.velocity.assign(state.scene.walls.size(), Vec3{});
  state.boundary.hold_force.assign(state.scene.walls.size(), Vec3{});
  if (particles == nullptr) pack_at_walls(state, initial);
  fill_particles(state, initial);
  state.soil_count = static_cast<std::size_t>(state.particles.count());
  state.soil_mass = state.particles.mass();
  look_at_all_soil(state);
  stop_if_asked(state.options.stop);
  place_walls(state);
  stop_if_asked(state.options.stop);
  const Particles& soil = initial.particles;
  for (const Probe& probe : state.scene.probes) {
    const ChosenParticle chosen = particle_of_probe(state.scene, soil, probe);
    state.probe_particles.push_back(
        {probe.name, soil.id[chosen.id], soil.position[chosen.id], chosen.distance, chosen.tied});
  }
  start_ledger(state);
  return state;
}

void take_part(State& state) {
  state.reduction->divide(state.particles);
  state.changed = ghost_fields;
  fit_records(state);
}

}  // namespace scarp
