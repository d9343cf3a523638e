// SPDX-License-Identifier: BSD-3-Clause
/// What a step did, and which bound set its size.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace scarp {

/// Which bound set a time step (THEORY.md section 10): sound in the stiffest soil, approach faster
/// than that sound, acceleration, artificial viscosity, stress diffusion; or the rate at which
/// steps may grow, the end of the stage.
enum class StepLimit { acoustic, approach, force, viscous, diffusion, growth, stage_end };
inline constexpr const char* step_limit_names[]{"acoustic",  "approach", "force",    "viscous",
                                                "diffusion", "growth",   "stage_end"};
inline const char* name_of(StepLimit limit) {
  const auto index = static_cast<std::size_t>(limit);
  return index < std::size(step_limit_names) ? step_limit_names[index] : "unknown";
}
/// How many steps each limit has set.
using StepLimitCounts = std::array<std::uint64_t, std::size(step_limit_names)>;

/// What the last step did.
struct StepReport {
  std::uint64_t step = 0;
  double time = 0.0;        ///< simulated time since the start [s]
  double stage_time = 0.0;  ///< since the start of the stage [s]
  double time_step = 0.0;   ///< [s]
  StepLimit limit = StepLimit::acoustic;
  double max_velocity = 0.0;        ///< of the soil that is not lost [m/s]
  std::size_t signal_material = 0;  ///< index of the material in which signals are fastest
};
}  // namespace scarp
