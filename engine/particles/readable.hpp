// SPDX-License-Identifier: BSD-3-Clause
/// Reads a row of the field table in a slot, whether the field is stored or derived.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/particles/particle_buffers.hpp"

namespace scarp {

/// What fields are read from.
struct Readable {
  const ParticleBuffers& particles;
  const std::vector<std::int64_t>& lost_ids;  ///< ascending

  /// One component in a slot; 0 where it is not stored (z in 2D).
  double value(const FieldRow& field, std::int64_t slot, int component) const;
};

}  // namespace scarp
