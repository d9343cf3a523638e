// SPDX-License-Identifier: BSD-3-Clause
/// Where a run stands in its integrator's cycle, and the phases of both integrators.
#pragma once

#include "engine/integrate/step_report.hpp"
#include "engine/integrate/time_step.hpp"
#include "engine/step/phase.hpp"
#include "engine/sweep/pair_sweeps.hpp"

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
  double sound_speed = 0.0;   ///< the fastest of the undisturbed soil [m/s]
  double acoustic_cfl = 0.0;  ///< largest CFL number for sound on the undisturbed lattice (T1)
  DampingRates damping_rates;
  StepLimitCounts counts{};
};

void choose_time_step(State& state);  ///< from the rates at hand. Errors: SimulationInstability
void advance_verlet(State& state);    ///< stress and every level of time. Equation: E28, E29
void kick_half(State& state);         ///< velocity over half a step. Equation: I1
void drift_half(State& state);        ///< position and walls over half a step
void advance_stress(State& state);    ///< stress and density over the step

namespace phases {

inline constexpr DataSet point_history{
    Field::density, Field::stress,      Field::diffusivity,  Field::strain_rate,
    Part::history,  Field::stress_work, Field::plastic_work, Field::diffusion_work};
inline constexpr DataSet verlet_levels{Field::position, Field::velocity, Field::previous_velocity,
                                       Field::previous_density, Field::previous_stress};
inline constexpr Phase choose_time_step{
    "choose_time_step",
    {Field::velocity, Field::acceleration, Field::density, Field::approach_rate},
    Part::walls,
    scarp::choose_time_step};
inline constexpr Phase advance_verlet{
    "advance_verlet",
    point_history | verlet_levels | gradient_output | DataSet(Field::acceleration, Part::walls),
    point_history | verlet_levels | DataSet(Part::walls), scarp::advance_verlet};
inline constexpr Phase kick_half{
    "kick_half", {Field::velocity, Field::acceleration}, Field::velocity, scarp::kick_half};
inline constexpr Phase drift_half{"drift_half",
                                  {Field::position, Field::velocity, Part::walls},
                                  {Field::position, Part::walls},
                                  scarp::drift_half};
inline constexpr Phase advance_stress{"advance_stress", point_history | gradient_output,
                                      point_history | DataSet(Field::force_moment),
                                      scarp::advance_stress};

}  // namespace phases

}  // namespace scarp
