// SPDX-License-Identifier: BSD-3-Clause
/// How far bodies reach along an axis.
#pragma once

#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

struct BodyRange {
  double low = 0.0, high = 0.0;  ///< [m]
};

/// The axis along which gravity is strongest; 0 without gravity.
std::size_t gravity_axis(const Scene& scene);

/// By body. The top of a height field is looked up every spacing, as an expression tells no bounds.
std::vector<BodyRange> body_ranges(const Scene& scene, std::size_t axis);

}  // namespace scarp
