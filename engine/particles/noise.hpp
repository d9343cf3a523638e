// SPDX-License-Identifier: BSD-3-Clause
/// Noise in which an instability can grow.
#pragma once

#include "engine/particles/particle_buffers.hpp"

namespace scarp {

/// Adds to each velocity pseudo-random components within +-`speed` [m/s], by the ids alone.
void add_noise(ParticleBuffers& particles, double speed);

}  // namespace scarp
