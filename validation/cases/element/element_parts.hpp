// SPDX-License-Identifier: BSD-3-Clause
/// The parts of the case `element`; each adds its measures and its table.
#pragma once

#include <array>
#include <string_view>

#include "engine/element/material_point.hpp"
#include "validation/case_run.hpp"

namespace scarp::validation {

inline constexpr std::array<std::string_view, 3> cone_names{"plane_strain", "outer", "inner"};
inline constexpr double confining_pressure = 100e3;  ///< at the start, and of the stress held [Pa]

/// Every soil and cone along every path against its closed form. Table: paths.csv.
void failure_paths(CaseRun& run);

/// One soil's stress paths for the figure. Tables: stress_paths.csv, yield_line.csv.
void draw_stress_paths(CaseRun& run);

/// Stress under rotation, and how errors fall with the number of strain steps. Table:
/// convergence.csv.
void step_counts(CaseRun& run);

/// Return mapping beside the two rate forms. Table: plasticity.csv.
void plasticity_forms(CaseRun& run);

/// Strain steps of a form: as given in the main form, a quarter in the short and four times as many
/// in the full one.
int steps_of(const CaseRun& run, int main);

/// Pure shear with dilation: `strain` both of shear, gamma = sqrt(2 e:e) of the deviator, and of
/// volume; without strain along z in 2D.
GradientIncrement shear_with_dilation_path(int dimension, double strain);

/// The scene with this match of the cone in all its soils.
Scene with_cone(Scene scene, std::size_t cone);

}  // namespace scarp::validation
