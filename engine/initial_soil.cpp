// SPDX-License-Identifier: BSD-3-Clause
/// Fills the bodies, or takes what is given.
#include "engine/initial_soil.hpp"

#include <cmath>

#include "engine/boundary/wall_clearance.hpp"
#include "engine/particles/generate.hpp"
#include "engine/scene/vector.hpp"

namespace scarp {
namespace {

/// The weight above is known by columns of the lattice; a particle that moved from there takes or
/// leaves the soil between.
void move_in(const Scene& scene, const std::vector<Vec3>& before, InitialSoil& soil) {
  using namespace geometry;
  const double g = std::sqrt(dot(scene.gravity, scene.gravity));
  for (std::size_t k = 0; k < soil.above.size(); ++k) {
    const double risen = dot(upward(scene), minus(soil.particles.position[k], before[k]));
    soil.above[k].thickness -= risen;
    soil.above[k].pressure -= scene.materials[soil.particles.material[k]].density * g * risen;
  }
}

}  // namespace

InitialSoil drawn_soil(const State& state, const Particles* given) {
  const Scene& scene = state.scene;
  const auto& stop = state.options.stop;
  InitialSoil soil;
  soil.particles = completed(scene, given != nullptr ? *given : generate_soil(scene, stop));
  check_wall_clearance(scene, soil.particles, stop);
  if (scene.initial_stress == InitialStress::geostatic && soil.particles.stress.empty())
    soil.above = soil_above(scene, soil.particles, state.threads);
  return soil;
}

void pack_at_walls(State& state, InitialSoil& soil) {
  if (!state.scene.numerics.relaxed_packing) return;
  const std::vector<Vec3> before = soil.particles.position;
  state.packing = relax_packing(state.scene, state.boundary.surface, state.boundary.dummies,
                                state.threads, state.options.stop, soil.particles);
  if (state.packing.moved > 0) move_in(state.scene, before, soil);
}

}  // namespace scarp
