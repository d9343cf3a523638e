// SPDX-License-Identifier: BSD-3-Clause
/// Particles by their place on the lattice.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/scene/vector.hpp"

namespace scarp {

/// Site k of an axis stands for the cell from origin + k dx to origin + (k + 1) dx.
using Site = std::array<std::int64_t, 3>;

/// From a site to all others no farther away than `reach` spacings, ascending.
inline std::vector<Site> offsets_within(double reach, int dimension) {
  std::vector<Site> offsets;
  const auto far = static_cast<std::int64_t>(reach);
  const std::int64_t deep = dimension == 3 ? far : 0;
  for (std::int64_t x = -far; x <= far; ++x) {
    for (std::int64_t y = -far; y <= far; ++y) {
      for (std::int64_t z = -deep; z <= deep; ++z) {
        const auto squared = static_cast<double>(x * x + y * y + z * z);
        if (squared > 0.0 && squared <= reach * reach) offsets.push_back({x, y, z});
      }
    }
  }
  return offsets;
}

/// Length of such a way in spacings.
inline double length_of(const Site& offset) {
  return std::sqrt(
      static_cast<double>(offset[0] * offset[0] + offset[1] * offset[1] + offset[2] * offset[2]));
}

/// Finds a particle by its site. Pre: no two share one.
class LatticePlaces {
 public:
  LatticePlaces(std::span<const Vec3> positions, const Vec3& origin, double spacing)
      : origin_(origin), spacing_(spacing) {
    for (std::size_t k = 0; k < positions.size(); ++k) sites_.push_back({site_of(positions[k]), k});
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

}  // namespace scarp
