// SPDX-License-Identifier: BSD-3-Clause
/// Where a run stands in its integrator's cycle, and the phases of both integrators.
#pragma once

#include "engine/integrate/step_report.hpp"
#include "engine/integrate/time_step.hpp"

namespace scarp {

struct State;

/// Place in the integrator's cycle.
struct StepClock {
  double time_step = 0.0;           ///< of this step
  double previous_time_step = 0.0;  ///< of the step before
  double growth_base = 0.0;         ///< last step before clipping to the end of a stage; 0: none
  int since_restart = 0;            ///< Verlet: steps since the last forward step
  bool restart = true;              ///< levels n-1 are not valid
  double step_factor = 1.0;         ///< on what the limits allow
  double kick = 0.0;                ///< time over which the last kick took the velocities
};

/// What bounds the time step, and how often each bound did.
struct StepLimits {
  double acoustic_cfl = 0.0;  ///< largest CFL number for sound on the undisturbed lattice (T1)
  DissipationRates dissipation;
  StepLimitCounts counts{};
};

void choose_time_step(
    State& state);  ///< Phase: from the rates at hand. Errors: SimulationInstability.
void advance_verlet(State& state);  ///< Phase: stress and every level of time. Equation: E28, E29.
void kick_half(State& state);       ///< Phase: velocity over half a step. Equation: I1.
void drift_half(State& state);      ///< Phase: position over half a step.
void advance_stress(State& state);  ///< Phase: stress and density over the step.

}  // namespace scarp
