// SPDX-License-Identifier: BSD-3-Clause
/// Rows of weak particles and what lies beside them on the lattice.
#include "engine/particles/weak_seams.hpp"

#include <array>
#include <optional>
#include <vector>

#include "engine/particles/lattice_places.hpp"

namespace scarp {
namespace {

bool is_weaker(const Material& one, const Material& other) {
  const std::optional<kernels::CoulombStrength> a = one.model.strength(),
                                                b = other.model.strength();
  if (!a) return false;
  if (!b) return true;  // elastic
  return a->cohesion <= b->cohesion && a->friction_angle <= b->friction_angle &&
         (a->cohesion < b->cohesion || a->friction_angle < b->friction_angle);
}

}  // namespace

void widen_weak_seams(const Scene& scene, const Vec3& origin, Particles& soil) {
  const std::size_t materials = scene.materials.size();
  std::vector<std::vector<bool>> weaker(materials, std::vector<bool>(materials));
  bool any = false;
  for (std::size_t a = 0; a < materials; ++a) {
    for (std::size_t b = 0; b < materials; ++b) {
      weaker[a][b] = is_weaker(scene.materials[a], scene.materials[b]);
      any = any || weaker[a][b];
    }
  }
  if (!any) return;
  const LatticePlaces places(soil.position, origin, scene.spacing);
  const std::vector<std::size_t> drawn = soil.material;
  const auto stronger_at = [&](const Site& site, std::size_t than) {
    const std::optional<std::size_t> k = places.at(site);
    return k && weaker[than][drawn[*k]] ? k : std::nullopt;
  };
  const std::array<std::size_t, 3> axes = scene.dimension == 2
                                              ? std::array<std::size_t, 3>{1, 0, 0}
                                              : std::array<std::size_t, 3>{2, 0, 1};
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    for (std::size_t turn = 0; turn < static_cast<std::size_t>(scene.dimension); ++turn) {
      Site below = places.site_of(soil.position[k]), above = below;
      --below[axes[turn]];
      ++above[axes[turn]];
      const std::optional<std::size_t> next = stronger_at(above, drawn[k]);
      if (!next || !stronger_at(below, drawn[k])) continue;
      soil.material[*next] = drawn[k];
      break;
    }
  }
}

}  // namespace scarp
