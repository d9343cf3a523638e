// SPDX-License-Identifier: BSD-3-Clause
/// Columns along gravity: where a point lies across it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "engine/boundary/facet_geometry.hpp"

namespace scarp {

/// Divides the line (2D) or plane (3D) across gravity into columns of one width. Pre: gravity is
/// not zero. With gravity along -y or -z the axes are x, and y.
class Across {
 public:
  using Column = std::array<std::int64_t, 2>;
  struct Hash {
    std::size_t operator()(const Column& column) const {
      auto hash = static_cast<std::uint64_t>(column[0]) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29U;
      hash = (hash ^ static_cast<std::uint64_t>(column[1])) * 0xBF58476D1CE4E5B9ULL;
      return static_cast<std::size_t>(hash ^ (hash >> 32U));
    }
  };

  Across(const Scene& scene, double width) : dimension_(scene.dimension), width_(width) {
    const double weight = std::sqrt(geometry::dot(scene.gravity, scene.gravity));
    down_ = geometry::plus({}, 1.0 / weight, scene.gravity);
    if (dimension_ == 2) {
      axis_[0] = {-down_[1], down_[0], 0.0};
      return;
    }
    const auto less = [](double a, double b) { return std::abs(a) < std::abs(b); };
    Vec3 level{};  // the axis of the scene that is least along gravity
    level[static_cast<std::size_t>(std::min_element(down_.begin(), down_.end(), less) -
                                   down_.begin())] = 1.0;
    level = geometry::plus(level, -geometry::dot(level, down_), down_);
    axis_[0] = geometry::plus({}, 1.0 / std::sqrt(geometry::dot(level, level)), level);
    axis_[1] = geometry::cross(axis_[0], down_);
  }

  double depth(const Vec3& point) const { return geometry::dot(point, down_); }
  /// Where a point lies across gravity [m].
  std::array<double, 2> place(const Vec3& point) const {
    return {geometry::dot(point, axis_[0]), geometry::dot(point, axis_[1])};
  }
  Column column(const Vec3& point) const {
    const auto [u, v] = place(point);
    return {static_cast<std::int64_t>(std::floor(u / width_)),
            static_cast<std::int64_t>(std::floor(v / width_))};
  }
  /// Calls use(column) for a column and those around it.
  template <class Use>
  void around(const Column& column, const Use& use) const {
    const std::int64_t aside = dimension_ == 3 ? 1 : 0;
    for (std::int64_t i = -1; i <= 1; ++i) {
      for (std::int64_t j = -aside; j <= aside; ++j) use(Column{column[0] + i, column[1] + j});
    }
  }
  const Vec3& down() const { return down_; }

 private:
  int dimension_;
  double width_;
  Vec3 down_{};
  std::array<Vec3, 2> axis_{};
};

}  // namespace scarp
