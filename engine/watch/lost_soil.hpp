// SPDX-License-Identifier: BSD-3-Clause
/// Soil that nothing holds any more.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "engine/scene/scene.hpp"

namespace scarp {

/// Soil that has left everything that could hold it (THEORY.md section 10).
struct LostSoil {
  std::uint64_t particles = 0;
  double mass = 0.0;        ///< [kg, per metre in 2D]
  std::int64_t first = -1;  ///< id of the first one; the rest is about it, when it was found
  std::uint64_t step = 0;
  double time = 0.0;  ///< [s]
  std::string stage;
  Vec3 position{};

  /// "2 of 200 particles were lost ...", in one sentence.
  std::string message(std::size_t all) const;
};

}  // namespace scarp
