// SPDX-License-Identifier: BSD-3-Clause
/// The picture of a failure.
#pragma once

#include <filesystem>

#include "engine/fos/strength_reduction.hpp"

namespace scarp {

/// Runs one factor on, with all outputs of a run in `folder`, until the judged point has moved five
/// times the limit of the criterion or twice its window is over: by then the slip surface shows.
/// Errors: FileError, SimulationInstability.
void run_failure(const StrengthReduction& slope, double reduction,
                 const std::filesystem::path& folder, const Proceed& proceed);

}  // namespace scarp
