// SPDX-License-Identifier: BSD-3-Clause
/// Finds edges of walls that nearly meet another wall.
#pragma once

#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp {

/// A sentence for each facet that ends within the reach 2h of another one without meeting it, the
/// gap lying beside the facet and not in front of it (a narrow box is open, not leaky). Soil can
/// leak through such a gap. One for each facet too that is lengthened because a gap is narrower
/// than a grain. Limits: edges are looked at every spacing.
std::vector<std::string> wall_gaps(const Scene& scene);

}  // namespace scarp
