// SPDX-License-Identifier: BSD-3-Clause
/// What all parts of a soil hold, put together in the part that leads.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/particles/particle_buffers.hpp"
#include "engine/particles/probe_sample.hpp"
#include "engine/particles/readable.hpp"
#include "engine/step/reduction.hpp"

namespace scarp {

/// The ids of all particles, ascending.
std::vector<std::int64_t> whole_ids(const ParticleBuffers& own, Reduction& parts);
/// One field in the order of the ids, its components side by side; 0 where one is not stored.
std::vector<double> whole_field(const Readable& own, const FieldRow& field, Reduction& parts);
/// All particles with the fields for which kept(row) holds; the particles of a group in the order
/// of the parts, each in its own. Nothing where there is but one part, which is the whole.
std::optional<ParticleBuffers> whole_soil(const ParticleBuffers& own, bool (*kept)(const FieldRow&),
                                          Reduction& parts);
/// What the particle of a probe shows, whichever part holds it. Errors: Error if none does.
ProbeSample whole_probe(const Scene& scene, const ParticleBuffers& own, const ProbeParticle& probe,
                        Reduction& parts);

}  // namespace scarp
