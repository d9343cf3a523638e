// SPDX-License-Identifier: BSD-3-Clause
/// What every benchmark program provides to the shared main.
#pragma once

namespace scarp::bench {

/// Registers the benchmarks of a program; `full`: every combination, hours instead of minutes.
void add_all(bool full);

}  // namespace scarp::bench
