// SPDX-License-Identifier: BSD-3-Clause
/// Reads the particle of a probe.
#include "engine/particles/probe_reading.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp {

ProbeSample read_probe(const Scene& scene, const ParticleBuffers& particles,
                       const ProbeParticle& probe) {
  const auto& ids = particles.ids();
  const auto found = std::find(ids.begin(), ids.end(), probe.particle);
  if (found == ids.end()) {
    throw Error(fmt::format(
        "probe '{}': it follows particle {}, which is not among the {} particles of this "
        "simulation. Try the part of the soil that holds it.",
        probe.probe, probe.particle, particles.count()));
  }
  const auto slot = found - ids.begin();
  const auto read = [&](Field field, int c) {
    const double* array = particles.component(field, c);
    return array != nullptr ? array[slot] : 0.0;
  };
  ProbeSample sample;
  sample.probe = probe.probe;
  for (int a = 0; a < 3; ++a) {
    const auto axis = static_cast<std::size_t>(a);
    sample.position[axis] = read(Field::position, a);
    sample.displacement[axis] = sample.position[axis] - read(Field::reference_position, a);
    sample.velocity[axis] = read(Field::velocity, a);
  }
  for (int c = 0; c < 6; ++c) sample.stress[static_cast<std::size_t>(c)] = read(Field::stress, c);
  sample.density = read(Field::density, 0);
  for (const kernels::StateField& field : history_of(scene)) {
    if (field.output) sample.history.push_back(particles.declared(field.name)[slot]);
  }
  return sample;
}

}  // namespace scarp
