// SPDX-License-Identifier: BSD-3-Clause
/// A field as the particles lie in memory.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace scarp {

/// A stored field without a copy, as it is until the simulation is stepped, changed, moved from or
/// destroyed. What it shows then is not defined.
struct FieldView {
  std::span<const std::int64_t> ids;  ///< permanent id of each slot; -1: it only pads
  /// One number for each slot [SI]: x, y, z; xx, yy, zz, xy, yz, zx. In 2D z, yz and zx are 0
  /// everywhere and are left out.
  std::vector<std::span<const double>> components;
};

}  // namespace scarp
