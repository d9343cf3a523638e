// SPDX-License-Identifier: BSD-3-Clause
/// Reading of neighbour lists.
#pragma once

#include "kernels/always_inline.hpp"
#include "kernels/particle_view.hpp"

namespace scarp::kernels {

/// The records of one block of a neighbour list.
struct NeighbourBlock {
  std::int32_t record[entry_block];

  SCARP_INLINE NeighbourBlock(const NeighbourView& lists, std::int64_t block) {
    const std::uint16_t* place = lists.place + block * entry_block;
    const std::int32_t page = lists.page[block];
    for (int k = 0; k < entry_block; ++k)
      record[k] = place[k] == no_neighbour ? lists.far_record : page + place[k];
  }
};

}  // namespace scarp::kernels
