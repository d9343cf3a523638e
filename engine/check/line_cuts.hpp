// SPDX-License-Identifier: BSD-3-Clause
/// All bodies of a scene, cut along a line parallel to an axis.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/particles/shapes.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// What lies between two places of a line.
struct LinePiece {
  double low = 0.0;
  double high = 0.0;
  int material = -1;  ///< -1: air between soil
  int body = -1;      ///< the first of those merged; -1: air
};

/// Bodies as lines see them: a point in several belongs to the first.
class LineCuts {
 public:
  /// `scene` must outlive it.
  explicit LineCuts(const Scene& scene);

  /// Whether lines along this axis can be cut: tops of height fields are known vertically only.
  bool knows(std::size_t axis) const;
  const Vec3& minimum() const { return minimum_; }  ///< of all bodies [m]
  const Vec3& maximum() const { return maximum_; }
  /// Corners of the bodies along an axis, ascending [m].
  std::vector<double> corners(std::size_t axis) const;
  /// The pieces of the line along `axis` through `at`, ascending and without gaps; neighbours of
  /// one material are one piece.
  std::vector<LinePiece> cut(std::size_t axis, const Vec3& at) const;

 private:
  /// Where a body begins (1) or ends (-1).
  struct End {
    double place;
    int body, step;
  };
  void ranges_of(std::size_t body, std::size_t axis, const Vec3& at, std::vector<Range>& out) const;

  const Scene& scene_;
  std::vector<ColumnShape> shapes_;
  std::vector<int> materials_;  ///< of the bodies
  Vec3 minimum_{}, maximum_{};
};

}  // namespace scarp
