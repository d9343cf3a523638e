// SPDX-License-Identifier: BSD-3-Clause
/// Stages of a run: settle, reduce the strength, remove walls, end.
#pragma once

#include <cstddef>

#include "engine/step/phase.hpp"

namespace scarp {

struct State;

/// Clock and control of the stages.
struct StageClock {
  std::size_t index = 0;
  bool started = false;  ///< the first stage has been entered
  bool ended = false;
  bool reached_rest = false;
  double time = 0.0;         ///< since the stage began
  double calm_since = -1.0;  ///< stage time since when the soil has been slower than rest_velocity
  double damping = 0.0;      ///< c_d in force
  double rest_window = 0.0;  ///< how long calm must last
  double start_speed = 0.0;  ///< fastest particle or wall when the stage began [m/s]
};

void enter_stage(State& state);  ///< the first, or the one after the present one
/// Takes the moment of where the soil is for that of the force; before the first step also takes
/// geostatic stress to balance at free surfaces, sigma <- sym(sigma M): the force is summed of
/// sigma B, which then is the geostatic stress. Equation: K3.
void take_moment(State& state);
void end_step(State& state);              ///< clocks, lost soil, the stage's end
double soil_height(const State& state);   ///< extent along gravity of what is not lost [m]
double fastest_soil(const State& state);  ///< ... and its largest speed [m/s]

namespace phases {

inline constexpr DataSet reset_fields =
    fields_where([](const FieldRow& field) { return field.reset == Reset::reset; });
inline constexpr Phase enter_stage{"enter_stage",
                                   reset_fields | DataSet(Field::position, Part::walls),
                                   reset_fields | DataSet(Field::asleep, Field::stirred_time,
                                                          Part::records, Part::lists, Part::walls),
                                   scarp::enter_stage};
inline constexpr Phase take_moment{"take_moment",
                                   {Field::stress, Field::moment},
                                   {Field::stress, Field::force_moment},
                                   scarp::take_moment};
inline constexpr Phase end_step{
    "end_step",
    {Field::position, Field::velocity, Field::reference_position, Part::walls},
    {},
    scarp::end_step};

}  // namespace phases

}  // namespace scarp
