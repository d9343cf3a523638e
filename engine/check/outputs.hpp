// SPDX-License-Identifier: BSD-3-Clause
/// What the outputs of a run will cost, and the memory it takes with them.
#pragma once

#include <string>

#include "engine/check/forecast.hpp"
#include "engine/simulation.hpp"

namespace scarp::check {

struct OutputTrial {
  double frame_bytes = 0.0, frame_seconds = 0.0;  ///< of one frame, without the disk
  double checkpoint_bytes = 0.0;
  double peak_bytes = 0.0;  ///< most resident memory so far, with a frame and a checkpoint
};

/// Makes a frame and a checkpoint in memory, as the run will. To be asked before anything that the
/// run does not do.
OutputTrial try_outputs(const Simulation& simulation);

/// The same for a scene of `share` times as many particles.
OutputTrial scaled(OutputTrial trial, double share);

/// Frames of the whole run; NaN if its length is not known.
double expected_frames(const Scene& scene, const Forecast& forecast);

/// What to say of frames that fall on every step or so; empty if there is nothing.
std::string frames_warning(const Scene& scene, const Forecast& forecast, const OutputTrial& trial);

}  // namespace scarp::check
