// SPDX-License-Identifier: BSD-3-Clause
/// Second lines of the records: what some pair terms need of a particle beyond its record.
#pragma once

#include "engine/particles/particle_buffers.hpp"
#include "engine/sweep/chosen_kernels.hpp"
#include "engine/sweep/records.hpp"

namespace scarp {

/// Soil that has second lines.
struct SecondSources {
  const ParticleBuffers& owned;
  const ParticleBuffers& ghosts;
};

/// Writes the second lines of all soil for the terms of a run that have values there, marks those
/// that are not zero, and returns whether any is. Takes memory for them from the first time on that
/// any is.
bool pack_second_lines(int threads, const SecondSources& soil, const ChosenKernels& chosen,
                       Records& records);

}  // namespace scarp
