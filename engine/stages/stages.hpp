// SPDX-License-Identifier: BSD-3-Clause
/// Stages of a run: settle, reduce the strength, remove walls, end.
#pragma once

#include <cstddef>

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

void enter_stage(State& state, std::size_t index);
void end_step(State& state);              ///< Phase: clocks, moving walls, the end of the stage.
double soil_height(const State& state);   ///< extent along gravity of what is not lost [m]
double fastest_soil(const State& state);  ///< ... and its largest speed [m/s]

}  // namespace scarp
