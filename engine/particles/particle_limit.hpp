// SPDX-License-Identifier: BSD-3-Clause
/// How many particles the memory of this machine can hold.
#pragma once

#include <unistd.h>

namespace scarp {

/// Memory a particle takes in a run: state, records, neighbour lists and output buffers [bytes].
inline constexpr double bytes_per_particle = 1000.0;

/// Physical memory [bytes]; a system that does not tell counts as 4 GB.
inline double physical_memory() {
  const double pages = static_cast<double>(sysconf(_SC_PHYS_PAGES));
  const double page = static_cast<double>(sysconf(_SC_PAGESIZE));
  return pages > 0.0 && page > 0.0 ? pages * page : 4e9;
}

/// Most particles worth starting with; a guard against a mistyped spacing, no promise.
inline double most_particles() { return physical_memory() / bytes_per_particle; }

}  // namespace scarp
