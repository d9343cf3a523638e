// SPDX-License-Identifier: BSD-3-Clause
/// The one table of particle fields: it drives allocation, sorting, snapshots and output.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace scarp {

struct Readable;

/// What a field must survive: `state` is carried through a re-sort; `step_end` is a rate that the
/// next step's size is chosen by, before any re-sort; `rate` lives within a step. A snapshot holds
/// the first two. `derived` fields are stored nowhere: `FieldRow::derived` computes them.
enum class Lifetime { state, step_end, rate, derived };

enum class Field : std::size_t {
  position,
  velocity,
  density,
  stress,
  previous_velocity,
  previous_density,
  previous_stress,
  reference_position,
  build_position,
  diffusivity,
  stress_work,
  plastic_work,
  diffusion_work,
  asleep,
  stirred_time,
  stirred_history,
  rest_acceleration,
  rest_change,
  acceleration,
  density_rate,
  velocity_gradient,
  moment,
  force_moment,
  strain_rate,
  approach_rate,
  diffusion_rate,
  diffusion_slope,
  displacement,
  id,
  material,
  lost,
  count
};

enum class Rank { scalar, vector, symmetric, tensor };

/// What all slots hold, padding included, until something else is put in. A reset puts it back.
struct Initial {
  enum class From { value, position, reference_density } from = From::value;
  double value = 0.0;
};

/// Whether the end of a stage with `reset_after` puts the initial value back.
enum class Reset { kept, reset };

/// Whether a copy of a particle that stands in for it elsewhere (a ghost) must carry the field:
/// everything that a neighbour reads of a particle.
enum class Ghost { own, ghost };

/// When a value that is not finite ends the run: never; where the step's size is chosen by it, in
/// each step; and besides when the watch looks at the whole soil. `near`: a position, which in a
/// snapshot must be near those of the scene.
enum class Check { unchecked, each_step, each_look, near };

/// Where a field can be read: nowhere outside the engine; by its name, with Simulation::field; in
/// frames too, as numbers of 32-bit floating point or whole numbers.
enum class Readout { inside, by_name, real, int32, int64 };

struct FieldRow {
  Field field;
  const char* name;
  const char* unit;
  Rank rank;
  Lifetime lifetime;
  Initial initial;
  Reset reset;
  Ghost ghost;
  Check check;
  Readout readout;
  const char* description;
  /// Of a derived field: the value of one component in a slot.
  double (*derived)(const Readable& from, std::int64_t slot, int component) = nullptr;
};

// engine/particles/readable.cpp
double displacement_of(const Readable& from, std::int64_t slot, int component);
double id_of(const Readable& from, std::int64_t slot, int component);
double material_of(const Readable& from, std::int64_t slot, int component);
double lost_of(const Readable& from, std::int64_t slot, int component);

/// One row per field: what each part of the engine does with it follows from its columns.
inline constexpr std::array<FieldRow, static_cast<std::size_t>(Field::count)> field_list = [] {
  using enum Rank;
  using enum Lifetime;
  using enum Reset;
  using enum Ghost;
  using enum Check;
  using enum Readout;
  constexpr Initial zero{}, place{Initial::From::position},
      reference_density{Initial::From::reference_density};
  return std::array<FieldRow, static_cast<std::size_t>(Field::count)>{{
      {Field::position, "position", "m", vector, state, zero, kept, ghost, near, by_name,
       "position"},
      {Field::velocity, "velocity", "m/s", vector, state, zero, reset, ghost, each_step, real,
       "velocity"},
      {Field::density, "density", "kg/m3", scalar, state, reference_density, kept, ghost, each_look,
       real, "density"},
      {Field::stress, "stress", "Pa", symmetric, state, zero, kept, ghost, each_look, real,
       "stress, tension positive"},
      {Field::previous_velocity, "previous_velocity", "m/s", vector, state, zero, kept, own,
       unchecked, inside, "velocity one step before (Verlet)"},
      {Field::previous_density, "previous_density", "kg/m3", scalar, state, reference_density, kept,
       own, unchecked, inside, "density one step before (Verlet)"},
      {Field::previous_stress, "previous_stress", "Pa", symmetric, state, zero, kept, own,
       unchecked, inside, "stress one step before (Verlet)"},
      {Field::reference_position, "reference_position", "m", vector, state, place, reset, own,
       unchecked, inside, "position that displacement counts from"},
      {Field::build_position, "build_position", "m", vector, state, zero, kept, own, near, inside,
       "position when the neighbour lists were built"},
      {Field::diffusivity, "diffusivity", "m2/s", scalar, state, zero, kept, ghost, unchecked,
       inside, "diffusivity of the stress diffusion"},
      {Field::stress_work, "stress_work", "J/kg", scalar, state, zero, reset, own, unchecked,
       inside, "work of the stress on the strain"},
      {Field::plastic_work, "plastic_work", "J/kg", scalar, state, zero, reset, own, unchecked,
       real, "work of the stress on the plastic strain"},
      {Field::diffusion_work, "diffusion_work", "J/kg", scalar, state, zero, reset, own, unchecked,
       inside, "elastic energy taken by the stress diffusion"},
      {Field::asleep, "asleep", "-", scalar, state, zero, kept, own, unchecked, int32,
       "1 where the particle sleeps, else 0"},
      {Field::stirred_time, "stirred_time", "s", scalar, state, zero, kept, own, unchecked, inside,
       "when the particle was last seen to move, yield or be out of balance"},
      {Field::stirred_history, "stirred_history", "-", scalar, state, zero, kept, own, unchecked,
       inside, "sum of the history variables when the particle last yielded"},
      {Field::rest_acceleration, "rest_acceleration", "m/s2", vector, state, zero, kept, own,
       unchecked, inside, "acceleration when it was first summed with the particle asleep"},
      {Field::rest_change, "rest_change", "m/s2", vector, state, zero, kept, own, unchecked, inside,
       "mean of what it has changed by since, over the time of a passage of sound"},
      {Field::acceleration, "acceleration", "m/s2", vector, state, zero, kept, own, each_step,
       inside, "acceleration without gravity and damping"},
      {Field::density_rate, "density_rate", "kg/m3/s", scalar, rate, zero, kept, own, unchecked,
       inside, "density rate"},
      {Field::velocity_gradient, "velocity_gradient", "1/s", tensor, rate, zero, kept, own,
       unchecked, inside, "velocity gradient as the sweep sums it"},
      {Field::moment, "moment", "-", symmetric, rate, zero, kept, own, unchecked, inside,
       "moment of the gradient correction"},
      {Field::force_moment, "force_moment", "-", symmetric, state, zero, kept, ghost, unchecked,
       inside, "moment where and when the force is summed"},
      {Field::strain_rate, "strain_rate", "1/s", symmetric, state, zero, reset, ghost, unchecked,
       inside, "strain rate of the corrected gradient"},
      {Field::approach_rate, "approach_rate", "m/s", scalar, step_end, zero, kept, own, each_step,
       inside, "largest rate of approach of a neighbour"},
      {Field::diffusion_rate, "diffusion_rate", "Pa/s", symmetric, rate, zero, kept, own, unchecked,
       inside, "stress rate of the diffusion before its lithostatic part"},
      {Field::diffusion_slope, "diffusion_slope", "m2/s3", scalar, rate, zero, kept, own, unchecked,
       inside, "lithostatic weight of the diffusion"},
      {Field::displacement, "displacement", "m", vector, derived, zero, kept, own, unchecked, real,
       "displacement since the last reset", displacement_of},
      {Field::id, "id", "-", scalar, derived, zero, kept, own, unchecked, int64,
       "permanent number of the particle", id_of},
      {Field::material, "material", "-", scalar, derived, zero, kept, own, unchecked, int32,
       "index of the material in the scene", material_of},
      {Field::lost, "lost", "-", scalar, derived, zero, kept, own, unchecked, by_name,
       "1 where the particle is lost, else 0", lost_of},
  }};
}();

constexpr const FieldRow& row(Field field) { return field_list[static_cast<std::size_t>(field)]; }

/// The field of the k-th row that the soil models of a run declare beyond `field_list`.
constexpr Field declared_field(std::size_t k) {
  return static_cast<Field>(static_cast<std::size_t>(Field::count) + k);
}

/// Stored components of a rank: 2D leaves out z, yz and zx.
constexpr bool stores_component(Rank rank, int component, int dimension) {
  switch (rank) {
    case Rank::scalar:
      return component == 0;
    case Rank::vector:
      return component < dimension;
    case Rank::symmetric:
      return component < (dimension == 2 ? 4 : 6);
    case Rank::tensor:
      return component / 3 < dimension && component % 3 < dimension;
  }
  return false;
}

constexpr int component_count(Rank rank) {
  return rank == Rank::scalar ? 1 : rank == Rank::vector ? 3 : rank == Rank::symmetric ? 6 : 9;
}

}  // namespace scarp
