// SPDX-License-Identifier: BSD-3-Clause
/// Rows of weak particles and what lies beside them on the lattice.
#include "engine/particles/weak_seams.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace scarp {
namespace {

using Site = std::array<std::int64_t, 3>;

bool is_weaker(const Material& one, const Material& other) {
  const std::optional<kernels::CoulombStrength> a = one.model.strength(),
                                                b = other.model.strength();
  if (!a) return false;
  if (!b) return true;  // elastic
  return a->cohesion <= b->cohesion && a->friction_angle <= b->friction_angle &&
         (a->cohesion < b->cohesion || a->friction_angle < b->friction_angle);
}

/// Particles by their place on the lattice.
class Places {
 public:
  Places(const Particles& soil, const Vec3& origin, double spacing)
      : origin_(origin), spacing_(spacing) {
    for (std::size_t k = 0; k < soil.position.size(); ++k)
      sites_.push_back({site_of(soil.position[k]), k});
    std::sort(sites_.begin(), sites_.end());
  }

  Site site_of(const Vec3& position) const {
    Site site{};
    for (std::size_t a = 0; a < 3; ++a)
      site[a] = std::llround((position[a] - origin_[a]) / spacing_ - 0.5);
    return site;
  }

  std::optional<std::size_t> at(const Site& site) const {
    const auto found =
        std::lower_bound(sites_.begin(), sites_.end(), std::pair{site, std::size_t{}});
    if (found == sites_.end() || found->first != site) return {};
    return found->second;
  }

 private:
  Vec3 origin_;
  double spacing_;
  std::vector<std::pair<Site, std::size_t>> sites_;
};

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
  const Places places(soil, origin, scene.spacing);
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
