// SPDX-License-Identifier: BSD-3-Clause
/// Coloured layers of the cuboid, as the experiment shows its internal deformation.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/simulation.hpp"
#include "validation/cases/cuboid_3d/cuboid_measures.hpp"
#include "validation/paper/outcome.hpp"

namespace scarp::validation {

inline constexpr int layer_count = 6;  ///< of the fill, of equal height

/// Boundaries of the layers in the middle section and where each is steepest, its inflection point:
/// "boundary 1: inflection x [m]", "... z [m]"; how far these points are from the most sheared soil
/// of their height, and the plastic strain around them over the mean of the fill. Writes
/// layers.csv. Errors: FileError.
void measure_layers(const Simulation& fallen, const std::vector<double>& start,
                    const CuboidSize& size, const std::filesystem::path& folder, Outcome& outcome);

}  // namespace scarp::validation
