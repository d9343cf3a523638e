// SPDX-License-Identifier: BSD-3-Clause
/// Puts particles that are close together into the same cluster.
#pragma once

#include <cstdint>
#include <span>

#include "engine/cells/cell_grid.hpp"

namespace scarp {

/// Reorders slots inside blocks of 64 so that each `cluster_size` consecutive ones lie close
/// together: halves a block at the median along its longest side until clusters are left. A sweep
/// reads the union of its cluster's neighbourhoods, so compact clusters have shorter lists. Ties
/// are broken by slot; the result does not depend on the number of threads. Source: kd-tree,
/// Bentley (1975). Pre: 64 is a multiple of cluster_size.
void compact_clusters(int threads, const PointSpan& points, int cluster_size,
                      std::span<std::int32_t> slots);

}  // namespace scarp
