// SPDX-License-Identifier: BSD-3-Clause
/// Seams of weak soil that are one row of particles thick.
#pragma once

#include "engine/particles/particles.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// Gives every particle of a single row of weak soil between stronger soil a second one, the next
/// above it (in a steep seam the next along x, then y), so that the seam can slip. The velocity
/// gradient of a particle is that of its neighbours on both sides: a row that slips alone strains
/// the rows beside it as much as itself, and they, which do not yield, hold it. Two rows that slip
/// strain only themselves. Weaker is soil with less cohesion or a smaller friction angle and no
/// more of the other. `origin` is a corner of the lattice that the soil stands on. Limits: a seam
/// thinner than a spacing may have gaps, which stay.
void widen_weak_seams(const Scene& scene, const Vec3& origin, Particles& soil);

}  // namespace scarp
