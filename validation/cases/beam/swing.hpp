// SPDX-License-Identifier: BSD-3-Clause
/// A beam that is started with the velocity of its first mode, and what is read of its motion.
#pragma once

#include <optional>
#include <string>

#include "validation/case_run.hpp"
#include "validation/cases/beam/modes.hpp"

namespace scarp::validation {

/// Of its end: strains of 1e-4, so that zigzags in tension do not grow at the spacings of the case
/// [m].
inline constexpr double small_deflection = 0.001;

/// How a beam is started, and for how long it swings.
struct Start {
  Support support = Support::free_free;
  double deflection = small_deflection;  ///< of its end, that the closed form gives [m]
  double periods = 10.0;                 ///< of the closed form
};

/// Energies are over the kinetic energy at the start.
struct Swing {
  double frequency = 0.0;  ///< from the times at which the mode's velocity vanishes, over exact
  double amplitude = 0.0;  ///< half the way of the mode from peak to peak, first period, over exact
  double last_amplitude = 0.0;  ///< the same in the last period
  double energy = 0.0;          ///< kinetic and elastic, at the end
  double most_energy = 0.0;     ///< the largest at any time
  double viscous = 0.0, artificial_stress = 0.0, gradient_residue = 0.0;
  double periods = 0.0;  ///< until the end, or until the watch stopped the run
  bool whole = true;     ///< it reached its end
};

/// Energy that the artificial viscosity takes in the interior of a beam, over the energy that it
/// has, in the time of `radians` of its mode. A pair that approaches loses as E26 says; on a dense
/// lattice that is rho alpha h c <(n e n)^2> per volume, a mean over directions n of which the half
/// in approach counts, so 0.5 rho alpha h c (3 - 2 nu' + 3 nu'^2)/8 e_xx^2 in bending,
/// where e_yy = -nu' e_xx.
double viscous_share(const Scene& scene, const BendingMode& mode, double radians);

/// Runs the beam of the scene; its course is written beside the results as deflection_NAME.csv.
/// `last`: the simulation at its end. An instability ends it, and no error leaves.
Swing swing(CaseRun& run, const std::string& name, Scene scene, const Start& start,
            std::optional<Simulation>& last);

}  // namespace scarp::validation
