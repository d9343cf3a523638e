// SPDX-License-Identifier: BSD-3-Clause
/// Cells and lists of a run, and the phases that keep them.
#pragma once

#include <cstdint>

#include "engine/cells/cell_grid.hpp"
#include "engine/neighbours/neighbour_lists.hpp"

namespace scarp {

struct State;

struct Neighbours {
  CellGrid soil_cells, image_cells, wall_cells;
  NeighbourLists lists, wall_lists;
  bool valid = false;          ///< the lists hold where everything stands now
  std::uint64_t rebuilds = 0;  ///< of the lists so far
};

/// Phase: sorts, builds cells and lists where that is due; packs the records of soil and images.
void refresh_neighbours(State& state);
/// Cells, images and lists of where everything stands now; `refresh_neighbours` calls it when due.
void build_lists(State& state);
/// Records of soil and images where they stand now.
void pack_records(State& state);

}  // namespace scarp
