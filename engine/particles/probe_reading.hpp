// SPDX-License-Identifier: BSD-3-Clause
/// Reads the particle of a probe.
#pragma once

#include "engine/particles/particle_buffers.hpp"
#include "engine/particles/probe_sample.hpp"

namespace scarp {

/// What the particle of a probe shows now. Errors: Error where it is not among these particles,
/// which it need not be where they are a part of the soil.
ProbeSample read_probe(const Scene& scene, const ParticleBuffers& particles,
                       const ProbeParticle& probe);

}  // namespace scarp
