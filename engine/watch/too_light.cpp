// SPDX-License-Identifier: BSD-3-Clause
/// Inertia against that of the present neighbours.
#include "engine/watch/too_light.hpp"

#include <string>
#include <vector>

#include "engine/particles/shared_inertia.hpp"
#include "engine/state.hpp"
#include "engine/watch/watch.hpp"

namespace scarp {
namespace {

/// Of the inertia that is asked for: rounding up and the margin of the step leave room for 2.
constexpr double too_little = 0.25;

}  // namespace

void watch_inertia(const State& state) {
  if (!state.scaling.scales_mass) return;
  const ParticleBuffers& p = state.particles;
  Particles soil;
  std::vector<std::int64_t> slots;
  for (const ParticleGroup& group : p.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      Vec3 x{};
      for (int a = 0; a < p.dimension(); ++a)
        x[static_cast<std::size_t>(a)] = p.component(Field::position, a)[k];
      soil.position.push_back(x);
      soil.material.push_back(group.material);
      slots.push_back(k);
    }
  }
  const std::vector<double> asked = shared_inertia(state.scene, soil);
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const double own = p.group_of(slots[k]).mass_scaling;
    if (own >= too_little * asked[k]) continue;
    Instability found = at_particle(state, slots[k]);
    found.field = std::string("inertia over mass");
    found.unit = std::string("-");
    found.value = own;
    found.limit = too_little * asked[k];
    found.cause =
        "soil that has come to touch a part with mass_scaling, which only bears the step "
        "beside soil that touched it from the start";
    found.advice =
        "without mass_scaling of that part, or with less of it; a lower Young's modulus "
        "of it makes the step longer as well";
    throw SimulationInstability(found);
  }
}

}  // namespace scarp
