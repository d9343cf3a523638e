// SPDX-License-Identifier: BSD-3-Clause
/// The one table of particle fields: it drives allocation, sorting, snapshots and output.
#pragma once

#include <array>
#include <cstddef>

namespace scarp {

/// What a field must survive: `state` is carried through a re-sort; `step_end` is a rate that the
/// next step's size is chosen by, before any re-sort; `rate` lives within a step. A snapshot holds
/// the first two.
enum class Lifetime { state, step_end, rate };

enum class Field : std::size_t {
  position,
  velocity,
  density,
  stress,
  previous_velocity,
  previous_density,
  previous_stress,
  accumulated_plastic_strain,
  reference_position,
  build_position,
  diffusivity,
  stress_work,
  plastic_work,
  diffusion_work,
  acceleration,
  density_rate,
  velocity_gradient,
  moment,
  approach_rate,
  diffusion_rate,
  diffusion_slope,
  count
};

enum class Rank { scalar, vector, symmetric, tensor };

struct FieldRow {
  Field field;
  const char* name;
  const char* unit;
  Rank rank;
  Lifetime lifetime;
  bool output;  ///< written to frames and readable through Simulation::field
  const char* description;
};

inline constexpr std::array<FieldRow, static_cast<std::size_t>(Field::count)> field_list{{
    {Field::position, "position", "m", Rank::vector, Lifetime::state, false, "position"},
    {Field::velocity, "velocity", "m/s", Rank::vector, Lifetime::state, true, "velocity"},
    {Field::density, "density", "kg/m3", Rank::scalar, Lifetime::state, true, "density"},
    {Field::stress, "stress", "Pa", Rank::symmetric, Lifetime::state, true,
     "stress, tension positive"},
    {Field::previous_velocity, "previous_velocity", "m/s", Rank::vector, Lifetime::state, false,
     "velocity one step before (Verlet)"},
    {Field::previous_density, "previous_density", "kg/m3", Rank::scalar, Lifetime::state, false,
     "density one step before (Verlet)"},
    {Field::previous_stress, "previous_stress", "Pa", Rank::symmetric, Lifetime::state, false,
     "stress one step before (Verlet)"},
    {Field::accumulated_plastic_strain, "accumulated_plastic_strain", "-", Rank::scalar,
     Lifetime::state, true, "accumulated equivalent deviatoric plastic strain"},
    {Field::reference_position, "reference_position", "m", Rank::vector, Lifetime::state, false,
     "position that displacement counts from"},
    {Field::build_position, "build_position", "m", Rank::vector, Lifetime::state, false,
     "position when the neighbour lists were built"},
    {Field::diffusivity, "diffusivity", "m2/s", Rank::scalar, Lifetime::state, false,
     "diffusivity of the stress diffusion"},
    {Field::stress_work, "stress_work", "J/kg", Rank::scalar, Lifetime::state, false,
     "work of the stress on the strain"},
    {Field::plastic_work, "plastic_work", "J/kg", Rank::scalar, Lifetime::state, true,
     "work of the stress on the plastic strain"},
    {Field::diffusion_work, "diffusion_work", "J/kg", Rank::scalar, Lifetime::state, false,
     "elastic energy taken by the stress diffusion"},
    {Field::acceleration, "acceleration", "m/s2", Rank::vector, Lifetime::state, false,
     "acceleration without gravity and damping"},
    {Field::density_rate, "density_rate", "kg/m3/s", Rank::scalar, Lifetime::rate, false,
     "density rate"},
    {Field::velocity_gradient, "velocity_gradient", "1/s", Rank::tensor, Lifetime::rate, false,
     "velocity gradient as the sweep sums it"},
    {Field::moment, "moment", "-", Rank::symmetric, Lifetime::rate, false,
     "moment of the gradient correction"},
    {Field::approach_rate, "approach_rate", "m/s", Rank::scalar, Lifetime::step_end, false,
     "largest rate of approach of a neighbour"},
    {Field::diffusion_rate, "diffusion_rate", "Pa/s", Rank::symmetric, Lifetime::rate, false,
     "stress rate of the diffusion before its lithostatic part"},
    {Field::diffusion_slope, "diffusion_slope", "m2/s3", Rank::scalar, Lifetime::rate, false,
     "lithostatic weight of the diffusion"},
}};

constexpr const FieldRow& row(Field field) { return field_list[static_cast<std::size_t>(field)]; }

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
