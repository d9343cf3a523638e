// SPDX-License-Identifier: BSD-3-Clause
/// The picture of a failure.
#pragma once

#include <filesystem>

#include "engine/fos/strength_reduction.hpp"

namespace scarp {

/// Runs one factor on, with all outputs of a run in `folder`, from before the last step of its cut
/// until the judged point has moved 1.5 times the limit of the criterion, the slope has come to
/// rest, or twice its window is over: by then the slip surface shows. False: asked to stop. Errors:
/// FileError, SimulationInstability.
bool run_failure(StrengthReduction& slope, double reduction, const std::filesystem::path& folder,
                 const Proceed& proceed);

}  // namespace scarp
