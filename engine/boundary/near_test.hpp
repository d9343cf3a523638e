// SPDX-License-Identifier: BSD-3-Clause
/// Hash grid that tells whether a point is close to one put in before.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"

namespace scarp {

/// Finds points closer than a given distance to one put in before.
class NearTest {
 public:
  explicit NearTest(double distance) : distance_(distance) {}

  bool has_near(const Vec3& point, const std::vector<Vec3>& points) const {
    const CellKey centre = cell(point);
    for (std::int64_t k = 0; k < 27; ++k) {
      const auto entry =
          cells_.find({centre[0] + k % 3 - 1, centre[1] + k / 3 % 3 - 1, centre[2] + k / 9 - 1});
      if (entry == cells_.end()) continue;
      for (const std::size_t other : entry->second) {
        const Vec3 offset = geometry::minus(point, points[other]);
        if (geometry::dot(offset, offset) < distance_ * distance_) return true;
      }
    }
    return false;
  }
  void put(const Vec3& point, std::size_t index) { cells_[cell(point)].push_back(index); }

 private:
  using CellKey = std::array<std::int64_t, 3>;
  struct CellHash {
    std::size_t operator()(const CellKey& key) const {
      std::uint64_t hash = 0;
      for (const std::int64_t k : key) {
        hash = (hash ^ static_cast<std::uint64_t>(k)) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29;
      }
      return hash;
    }
  };

  CellKey cell(const Vec3& point) const {
    CellKey key{};
    for (std::size_t a = 0; a < 3; ++a) {
      key[a] = static_cast<std::int64_t>(std::floor(point[a] / distance_));
    }
    return key;
  }
  double distance_;
  std::unordered_map<CellKey, std::vector<std::size_t>, CellHash> cells_;
};

}  // namespace scarp
