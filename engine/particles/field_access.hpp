// SPDX-License-Identifier: BSD-3-Clause
/// Fields by their names, as programs see and change them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "engine/particles/field_view.hpp"
#include "engine/particles/particle_buffers.hpp"

namespace scarp {

/// Errors: Error for a field that the run does not store, or that is not read outside the engine.
FieldView view_field(const ParticleBuffers& particles, std::string_view name);

/// Puts `values` into the given slots, all components of a slot after one another; z, yz and zx
/// are passed over in 2D. Errors: Error, before anything is changed, for a field that is not part
/// of the state or is the position, another count of values, one that is not finite, and a density
/// that is not above 0.
void write_field(ParticleBuffers& particles, std::string_view name,
                 std::span<const std::int64_t> slots, std::span<const double> values);

}  // namespace scarp
