// SPDX-License-Identifier: BSD-3-Clause
/// The results of a run so far, in its checkpoints.
#pragma once

#include "engine/checkpoint/snapshot.hpp"
#include "engine/output/results.hpp"

namespace scarp {

/// Adds the stages that have ended and the retries.
void add_results(Snapshot& snapshot, const RunResults& results);
/// The same again; the rest is empty. Errors: CheckpointError.
RunResults results_in(const Snapshot& snapshot);

}  // namespace scarp
