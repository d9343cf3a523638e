// SPDX-License-Identifier: BSD-3-Clause
/// The ledger of the energies of a stage, and the phase that keeps it.
#pragma once

#include <cstdint>

#include "engine/energy/energy_balance.hpp"
#include "engine/step/phase.hpp"

namespace scarp {

struct State;

/// Powers of the forces on the soil [W], or their time integrals [J]; see EnergyBalance.
struct ForcePowers {
  double stress = 0.0, viscous = 0.0, artificial_stress = 0.0, damping = 0.0;
  double wall = 0.0, hold = 0.0;  ///< on moving walls: by pairs, and by the faces (B4)
};

/// What the hooks of a program have done to the soil of this part in the present stage.
struct HookWork {
  double net = 0.0;    ///< [J]
  double sum = 0.0;    ///< of the absolute values of all that they gave and took [J]
  double speed = 0.0;  ///< that a particle can have got from them at most [m/s]
};

/// Energies of the present stage: integrals of powers that are sampled every few steps.
struct EnergyLedger {
  ForcePowers work;
  ForcePowers last_powers;  ///< zero when a stage begins: it mostly begins at rest
  double last_time = 0.0;
  std::uint64_t last_step = 0;
  EnergyBalance start;  ///< stored energies when the stage began
  double stress_work_start = 0.0;
  HookWork hooks;
};

/// Powers of the forces, every few steps, where the output asks for energies. Called after
/// the force sweep of a step, with velocity and records of the same instant.
void sample_energy(State& state);
void start_ledger(State& state);  ///< at the start of a stage
EnergyBalance energy_balance(const State& state);
/// Kinetic, potential and elastic energy of the soil of this part [J].
double mechanical_energy(const State& state);

namespace phases {

inline constexpr Phase sample_energy{"sample_energy",
                                     {Field::velocity, Part::records, Part::lists, Part::walls},
                                     {},
                                     scarp::sample_energy};
inline constexpr Phase start_ledger{
    "start_ledger",
    {Field::position, Field::velocity, Field::density, Field::stress, Field::stress_work,
     Field::plastic_work, Field::diffusion_work},
    {},
    scarp::start_ledger};

}  // namespace phases

}  // namespace scarp
