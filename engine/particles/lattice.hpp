// SPDX-License-Identifier: BSD-3-Clause
/// The lattice that bodies are filled on, and where it begins.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/particles/shapes.hpp"
#include "engine/scene/scene.hpp"

namespace scarp {

/// Lattice sites first .. last of one axis; empty if last < first.
struct Sites {
  std::int64_t first = 0;
  std::int64_t last = -1;
  std::int64_t count() const { return std::max<std::int64_t>(last - first + 1, 0); }
};

/// Site i of an axis stands for the cell from origin + i dx to origin + (i + 1) dx.
struct Lattice {
  Vec3 origin{};
  double spacing = 1.0;

  double at(std::size_t axis, std::int64_t site) const {
    return origin[axis] + (static_cast<double>(site) + 0.5) * spacing;
  }
  /// Those of a shape in one of its ranges.
  Sites inside(const ColumnShape& shape, std::size_t axis, double low, double high) const {
    const double first = std::ceil((low + shape.begin[axis] - origin[axis]) / spacing - 0.5);
    const double last = std::floor((high + shape.tolerance - origin[axis]) / spacing - 0.5);
    constexpr double most = 4e18;  // an index beyond this does not fit and is refused by its count
    return {static_cast<std::int64_t>(std::clamp(first, -most, most)),
            static_cast<std::int64_t>(std::clamp(last, -most, most))};
  }
};

/// Anchored half a spacing inside the lowest corner of the first body, so that flat faces at
/// multiples of the spacing are met exactly. A polygon without any edge along an axis has none.
/// Where rows of the lattice run along its edges, mass and centre of its particles may then be off
/// as if the whole outline were off by a quarter of a spacing or more; its lattice is moved by
/// eighths of a spacing to where they are off least.
Lattice lattice_of(const Scene& scene, const ColumnShape& first);

}  // namespace scarp
