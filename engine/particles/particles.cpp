// SPDX-License-Identifier: BSD-3-Clause
/// Rules about particles that a program supplies.
#include "engine/particles/particles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "engine/errors.hpp"

namespace scarp {
namespace {

template <class Values>
void require_length(const Values& values, std::size_t count, const char* name) {
  if (values.size() == count) return;
  throw SceneError(
      fmt::format("particles: '{}' has {} entries for {} positions. Try one for each, or none.",
                  name, values.size(), count));
}

template <class Values>
void require_finite(const std::vector<Values>& values, const char* name) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    for (const double value : values[k]) {
      if (std::isfinite(value)) continue;
      throw SceneError(
          fmt::format("particles: '{}' of number {} is {}. Try a finite number.", name, k, value));
    }
  }
}

void require_single_ids(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  if (ids.front() < 0)
    throw SceneError(fmt::format("particles: an 'id' is {}. Try 0 or more.", ids.front()));
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end()) {
    throw SceneError(
        fmt::format("particles: 'id' {} comes twice. Try one of its own for each.", *twice));
  }
}

}  // namespace

Particles completed(const Scene& scene, Particles particles) {
  const std::size_t count = particles.position.size();
  if (count == 0) throw SceneError("particles: there are none. Try at least one position.");
  if (particles.velocity.empty()) particles.velocity.assign(count, Vec3{});
  if (particles.material.empty()) particles.material.assign(count, 0);
  if (particles.id.empty()) {
    particles.id.resize(count);
    std::iota(particles.id.begin(), particles.id.end(), 0);
  }
  require_length(particles.velocity, count, "velocity");
  require_length(particles.material, count, "material");
  require_length(particles.id, count, "id");
  if (!particles.stress.empty()) require_length(particles.stress, count, "stress");
  if (!particles.density.empty()) require_length(particles.density, count, "density");
  require_finite(particles.position, "position");
  require_finite(particles.velocity, "velocity");
  require_finite(particles.stress, "stress");
  require_single_ids(particles.id);
  for (std::size_t k = 0; k < count; ++k) {
    if (particles.material[k] >= scene.materials.size()) {
      throw SceneError(
          fmt::format("particles: 'material' of number {} is {}, but the scene has {}. Try an "
                      "index below that.",
                      k, particles.material[k], scene.materials.size()));
    }
    if (!particles.density.empty() && !(particles.density[k] > 0.0 && particles.density[k] < 1e9)) {
      throw SceneError(fmt::format(
          "particles: 'density' of number {} is {}. Try more than 0 and less than 1e9 kg/m3.", k,
          particles.density[k]));
    }
  }
  if (scene.bodies.empty() && particles.stress.empty() &&
      scene.initial_stress == InitialStress::geostatic) {
    throw SceneError(
        "particles: without bodies there is no telling what weight lies above. Try 'stress' for "
        "each particle, or an initial stress that is zero or uniform.");
  }
  return particles;
}

}  // namespace scarp
