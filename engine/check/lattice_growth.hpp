// SPDX-License-Identifier: BSD-3-Clause
/// Whether the lattice of the particles stands under a pressure.
#pragma once

#include "engine/scene/scene.hpp"
#include "kernels/smoothing/smoothing.hpp"

namespace scarp {

/// Soil on an undisturbed lattice under a uniform stress.
struct LoadedLattice {
  const kernels::SmoothingForm* smoothing = nullptr;
  double smoothing_ratio = 1.2;  ///< h/dx
  int dimension = 2;
  bool normalised = true;        ///< grad W over its lattice moment (K2)
  double spacing = 1.0;          ///< [m]
  double wave_modulus = 0.0;     ///< K + 4/3 G [Pa]
  double shear_modulus = 0.0;    ///< [Pa]
  double inertia = 0.0;          ///< mass density as inertia [kg/m3]
  double viscosity_alpha = 0.0;  ///< of E26
  double pressure = 0.0;         ///< along `down` [Pa]
  double k0 = 1.0;               ///< pressure across it over that along it
  Vec3 down{0.0, -1.0, 0.0};     ///< unit vector
};

/// Rate at which the fastest of its waves grows, without damping [1/s]; 0: none grows. Equation:
/// T2. The velocity gradient does not see waves as long as two rows, so that nothing elastic holds
/// them: whether they stand is up to the second derivative of W alone. Limits: waves with an
/// envelope of 16 spacings, soil that does not yield, no walls.
double growth_rate(const LoadedLattice& lattice);

}  // namespace scarp
