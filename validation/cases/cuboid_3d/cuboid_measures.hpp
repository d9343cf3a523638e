// SPDX-License-Identifier: BSD-3-Clause
/// What the collapse of the cuboid is judged by.
#pragma once

#include <filesystem>
#include <vector>

#include "engine/simulation.hpp"
#include "validation/paper/outcome.hpp"

namespace scarp::validation {

/// Faces of the scene after they have been moved to whole spacings [m].
struct CuboidSize {
  double gate, half_width, base_layer, fill, field_length, field_half_width;
};

CuboidSize cuboid_size(const Scene& scene);

/// Moves every face of bodies and walls to a whole number of spacings: a rest of a spacing would
/// start as a gap.
void snap_to_lattice(Scene& scene);

/// Mean way of the fill along x over the length of the box [-]. `start`: positions before anything
/// moved.
double mean_run_out(const Simulation& fallen, const std::vector<double>& start);

/// Force on the walls and residual velocity of the settled soil.
void measure_settled_cuboid(const Simulation& settled, Outcome& outcome);

/// Front, width, heights, face, layers, mass and energy of the deposit. `start`: positions before
/// anything moved. Writes the profiles at the middle plane, y = 100 mm and x = 212 mm, and the
/// layers' boundaries with their inflection points, as tables. Errors: FileError.
void measure_deposit(const Simulation& fallen, const std::vector<double>& start,
                     const std::filesystem::path& folder, Outcome& outcome);

}  // namespace scarp::validation
