// SPDX-License-Identifier: BSD-3-Clause
/// The parts of the case askew. Each turns its scene by angles in degrees against the lattice.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "validation/case_run.hpp"

namespace scarp::validation {

double radians(double degrees);

/// pi c_p/(2 H), critical for the first mode of a column of this height [1/s].
double damping_of(const Scene& scene, double height);

/// Judges a measure in the main and full form only, where there is time to look at what is missed.
void judge_in_long_forms(CaseRun& run, Measure measure);

/// Elastic layer on a rough base under gravity that is not normal to it.
void judge_layer(CaseRun& run, const std::string& preset, double spacing, double degrees,
                 std::optional<Simulation>& last);

/// The slope of the case slope_2d below its limit; the first angle is that of comparison.
void judge_slope(CaseRun& run, const std::string& preset, double spacing,
                 const std::vector<double>& angles, std::optional<Simulation>& last);

/// Its factor of safety.
void judge_factors(CaseRun& run, const std::string& preset, double spacing,
                   const std::vector<double>& angles);

}  // namespace scarp::validation
