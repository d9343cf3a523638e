// SPDX-License-Identifier: BSD-3-Clause
/// Particles in the order of their permanent ids, which is that of every read-out.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/particles/particle_buffers.hpp"

namespace scarp {

/// Slots of all particles in ascending order of their ids.
std::vector<std::int64_t> slots_by_id(const ParticleBuffers& particles);

}  // namespace scarp
