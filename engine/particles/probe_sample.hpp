// SPDX-License-Identifier: BSD-3-Clause
/// What a probe reads, and the particle that it follows.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

struct ProbeSample {
  std::string probe;
  Vec3 position{};
  Vec3 displacement{};
  Vec3 velocity{};
  std::array<double, 6> stress{};  ///< xx, yy, zz, xy, yz, zx, tension positive [Pa]
  double density = 0.0;
  std::vector<double>
      history;  ///< history variables that are written, in the order of `history_of`
};

/// The particle that a probe follows: the nearest one to its point at the start.
struct ProbeParticle {
  std::string probe;
  std::int64_t particle = 0;  ///< permanent id
  Vec3 start{};               ///< where it was at the start [m]
  double distance = 0.0;      ///< from the probe's point then [m]
  std::size_t tied = 1;       ///< particles that were as near, itself included
};

}  // namespace scarp
