// SPDX-License-Identifier: BSD-3-Clause
/// The variable time step, and the extremes of the state it and the stage control need.
#pragma once

#include <array>
#include <cstdint>

#include "engine/integrate/step_report.hpp"
#include "engine/particles/particle_buffers.hpp"
#include "engine/particles/slot_ranges.hpp"
#include "engine/scene/scene.hpp"
#include "engine/step/reduction.hpp"
#include "engine/sweep/records.hpp"
#include "kernels/pair/term.hpp"

namespace scarp {

/// Largest values over all soil particles after a sweep.
struct StateExtremes {
  double speed_squared = 0.0;         ///< [m2/s2]
  double acceleration_squared = 0.0;  ///< total, |f_a| of Eq. 30 squared [m2/s4]
  double signal_speed = 0.0;          ///< c_s + max_b(h v.r/r^2) of Eq. 30 [m/s]
  double approach = 0.0;              ///< max_b(h v.r/r^2) alone [m/s]
  std::size_t signal_material = 0;    ///< where the signal speed is largest
  std::int64_t bad_slot = -1;         ///< a particle with a value that is not finite, or -1
};

/// Reads velocity, acceleration, density and approach rate of these particles.
StateExtremes find_extremes(int threads, const ParticleBuffers& particles, const SlotRanges& which,
                            const RecordScaling& scaling, const Vec3& gravity, double damping);

/// Those of all parts of the soil; `bad_slot` stays this part's own.
void join(StateExtremes& extremes, Reduction& reduction);

/// By pair term, zero for those that damp nothing.
using DampingRates = std::array<kernels::DampingRate, kernels::term_count>;

/// Longest stable step for these extremes. Equation: E30; T1 for the dissipative terms.
struct AdmissibleStep {
  double time_step;
  StepLimit limit;
};
AdmissibleStep admissible_step(const StateExtremes& extremes, const DampingRates& rates,
                               double smoothing_length, double cfl);

}  // namespace scarp
