// SPDX-License-Identifier: BSD-3-Clause
/// Inertia of soil beside soil whose inertia is scaled.
#pragma once

#include <vector>

#include "engine/particles/particles.hpp"

namespace scarp {

/// Inertia over mass of each particle, decided at the start. Equation: I2; the stress of a stiff
/// particle pulls at its neighbours, so that each needs the inertia with which it bears the step
/// that the fastest sound c_max allows: s = <M>/(rho c_max^2) with the mean <M> of the wave moduli
/// of the neighbours by |grad W|, rounded up to a power of 2, where that is more than its
/// material's own. Pre: the particles are complete. Limits: soil that meets scaled soil later keeps
/// what it has.
std::vector<double> shared_inertia(const Scene& scene, const Particles& soil);

}  // namespace scarp
