// SPDX-License-Identifier: BSD-3-Clause
/// What the pair sums do to waves on the undisturbed lattice: moment, sound, damping.
#pragma once

#include <array>

#include "engine/integrate/time_step.hpp"
#include "engine/scene/scene.hpp"
#include "kernels/smoothing/smoothing.hpp"

namespace scarp {

/// Sums over a square or cubic lattice, lengths in h, without the lattice normalisation.
struct LatticeSums {
  double moment = 1.0;       ///< M = -1/d sum V r W'. Equation: K2
  double wave_number = 0.0;  ///< largest |sum V sin(k.x) grad W|: the stiffest wave has c times it
  /// By pair term: the largest sum of its `damping` (PairTerm); 0 for terms that damp nothing.
  std::array<double, kernels::term_count> damping{};
};

/// The largest over waves along axes and diagonals. Equation: T1.
LatticeSums lattice_sums(const kernels::SmoothingForm& form, double smoothing_ratio, int dimension);

/// Closed form of the largest CFL number without dissipation: 2/(wave number) for kick-drift-kick,
/// half of it for Verlet, which leaps over two steps. Equation: T1.
double acoustic_cfl_limit(const Numerics& numerics, const LatticeSums& sums);

/// Rates such that a CFL number that is stable without the dissipative terms stays so with them.
/// Equation: T1.
DampingRates damping_rates(const Numerics& numerics, const LatticeSums& sums,
                           const kernels::TermSettings& settings);

}  // namespace scarp
