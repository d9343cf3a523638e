// SPDX-License-Identifier: BSD-3-Clause
/// Runs a cell of the stability map and judges it.
#pragma once

#include <optional>
#include <string>

#include "engine/simulation.hpp"
#include "validation/stability/cells.hpp"

namespace scarp::validation {

/// Holds: ran to its end, and is stable at the CFL number in use. Restless: ran to its end, but
/// what should stand moves faster than 1e-4 sqrt(g H) then, 1 mm/s at a height of 10 m. Marginal:
/// ran to its end, but a trial at that number is unstable. Stopped: the watch stopped it with its
/// report. Refused: an error before the first step. Failed: grains lost or numbers not finite
/// without a report.
enum class Verdict { holds, restless, marginal, stopped, refused, failed };
const char* word(Verdict verdict);

struct CellRecord {
  std::string key;
  Verdict verdict = Verdict::holds;
  std::string reason;  ///< why it does not hold
  std::string limit;   ///< of the time step, that set most steps
  std::optional<double> stable_cfl, unstable_cfl;
  double energy_gain = 0.0;  ///< most that energy exceeded its start by, over what was spent
  double density_low = 1.0, density_high = 1.0;  ///< over the reference density
  double yield_overshoot = 0.0;                  ///< largest f over the strength at that pressure
  double lost = 0.0;                             ///< grains that passed a wall
  double noise = 0.0;                            ///< of the pressure at the end, `stress_noise`
  double shear_noise = 0.0;                      ///< of the shear stress
  double residual_velocity = 0.0;                ///< fastest grain at the end [m/s]
  double particles = 0.0, steps = 0.0, wall_s = 0.0;
};

/// Errors: none of the scene's or of the run's; they are the verdict.
CellRecord run_cell(const Cell& cell, const RunOptions& options);

}  // namespace scarp::validation
