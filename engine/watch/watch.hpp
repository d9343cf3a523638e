// SPDX-License-Identifier: BSD-3-Clause
/// Looks for states that soil cannot have, before a run ends in numbers that mean nothing.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/errors.hpp"
#include "engine/step/phase.hpp"

namespace scarp {

struct State;

/// Steps between two looks at density, stress and energy of the whole soil. Speed and finite
/// velocities, densities and accelerations are looked at in every step.
inline constexpr std::uint64_t steps_per_look = 50;

/// Advice that begins with what tells a time step that is too long from every other cause.
std::string advice_after_step_test(const char* then);

/// Step, time, stage and place filled in, the rest not.
Instability at_particle(const State& state, std::int64_t slot);

/// What happened to the particle whose velocity, density or acceleration is not finite.
Instability not_finite(const State& state, std::int64_t slot);

/// What makes the present state one that soil cannot have, if anything. THEORY.md section 10.
std::optional<Instability> inspect(const State& state);

/// What `inspect` finds, in the steps when it is due. Errors: SimulationInstability.
void watch(State& state);

/// Marks the particles that are lost now. With gravity: soil that falls, has fallen by more than
/// the reach 2h since the last reset, meets no wall that stands on its free flight from here, and
/// has no soil below it but such as falls likewise. Without: soil outside the box around all walls
/// by more than that reach, behind the wall that is nearest, on a straight way that meets none.
/// In a scene without walls nothing is lost. Once lost, a particle stays so: it goes on moving, but
/// neither rest nor the height of the soil asks for it. THEORY.md section 10.
void count_lost_soil(State& state);

/// Whether a particle has passed a face since the lists were built; called before they are built
/// anew, so what moves by half their skin is looked at. Errors: SimulationInstability.
void watch_walls(const State& state);

namespace phases {

inline constexpr DataSet looked_at =
    fields_where([](const FieldRow& field) { return field.check == Check::each_look; });
inline constexpr Phase watch{
    "watch",
    looked_at | DataSet(Field::position, Field::velocity, Field::density, Field::stress,
                        Field::reference_position, Field::stress_work, Field::plastic_work,
                        Field::diffusion_work),
    {},
    scarp::watch};

}  // namespace phases

}  // namespace scarp
