// SPDX-License-Identifier: BSD-3-Clause
/// The energies of a stage.
#pragma once

namespace scarp {

/// Energies [J, per metre of thickness in 2D]; dissipated parts are 0 unless `Output::energy`.
struct EnergyBalance {
  double kinetic = 0.0;
  double kinetic_added = 0.0;      ///< part of it: of inertia that `mass_scaling` adds
  double potential = 0.0;          ///< relative to the start of the stage
  double elastic = 0.0;            ///< relative to the start of the stage
  double plastic = 0.0;            ///< work of the stress on the plastic strain
  double viscous = 0.0;            ///< taken by the artificial viscosity (with the walls' share)
  double damping = 0.0;            ///< taken by F = -c_d v
  double wall = 0.0;               ///< work the soil does on walls
  double artificial_stress = 0.0;  ///< taken by the artificial stress
  double gradient_residue =
      0.0;                 ///< force power minus stress power: plain force, corrected gradient
  double diffusion = 0.0;  ///< elastic energy taken by the stress diffusion
  double hooks = 0.0;      ///< work that hooks of the program do on the soil
  double sleep = 0.0;      ///< kinetic energy of soil that fell asleep
  double imbalance = 0.0;  ///< what the lines above leave open
};

}  // namespace scarp
