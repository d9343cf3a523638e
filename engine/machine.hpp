// SPDX-License-Identifier: BSD-3-Clause
/// What the machine lets this process have: cores and memory.
#pragma once

#include <filesystem>

namespace scarp {

/// Limits of control groups (both versions), each the lowest of the process's own group and those
/// above it; infinite where there is none.
struct GroupLimits {
  double cores;         ///< processor time over time
  double memory_bytes;  ///< [bytes]
};

/// Reads /proc/self/{cgroup,mountinfo} and the files they name, all below `root` (for tests).
GroupLimits group_limits(const std::filesystem::path& root = "/");

/// Cores that this process may use: those OpenMP was given (affinity), no more than its control
/// group pays for, rounded up; at least 1.
int usable_cores();

/// Memory this process can take before it is refused or killed [bytes]: the least of physical
/// memory, its control group's and what `ulimit` allows for addresses and data. A system that does
/// not tell counts as 4 GB.
double usable_memory();

/// Resident memory of this process now and at most so far [bytes]; 0 if the system does not tell.
struct ResidentMemory {
  double now = 0.0, peak = 0.0;
};
ResidentMemory resident_memory();

}  // namespace scarp
