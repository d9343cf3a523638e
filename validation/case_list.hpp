// SPDX-License-Identifier: BSD-3-Clause
/// The registry: one row per case.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "validation/case_run.hpp"
#include "validation/paper/set_forecast.hpp"

namespace scarp::validation {

/// A case adds its measures and ends with `CaseRun::finish`. Errors: those of the library.
using CaseFunction = void (*)(CaseRun&);

/// A scalar error of a case, for `scarp-validate error-time` to sweep.
struct ErrorProblem {
  std::string_view error;          ///< what it is, in words
  std::array<double, 4> spacings;  ///< coarse to fine [m]
  /// Runs the scene to its end and returns the relative error. Errors: those of the library.
  double (*outcome)(CaseRun& run, const Scene& scene);
  /// The outcome is a value, not an error, to be held against what it tends to at the finest
  /// spacings.
  bool against_finest = false;
};

void slope_2d(CaseRun& run);
void cuboid_3d(CaseRun& run);
void slope_curvature(CaseRun& run);
void slope_corner(CaseRun& run);
void oedometer(CaseRun& run);
void elastic_wave(CaseRun& run);
void patch(CaseRun& run);
void disc_rotation(CaseRun& run);
void rings(CaseRun& run);
void couette(CaseRun& run);
void rest(CaseRun& run);
void element(CaseRun& run);
void footing(CaseRun& run);
void vertical_cut(CaseRun& run);
void column_2d(CaseRun& run);
void column_axisymmetric(CaseRun& run);
void aluminium_bars(CaseRun& run);
void slopes_fos(CaseRun& run);
void circular_footing(CaseRun& run);
void retrogression(CaseRun& run);
void beam(CaseRun& run);
void askew(CaseRun& run);
extern const ErrorProblem slope_2d_problem;
extern const ErrorProblem cuboid_3d_problem;
extern const ErrorProblem oedometer_problem;
extern const ErrorProblem elastic_wave_problem;
extern const ErrorProblem disc_rotation_problem;
extern const ErrorProblem footing_problem;
extern const ErrorProblem aluminium_bars_problem;
extern const ErrorProblem beam_problem;
extern const ErrorProblem askew_problem;

/// The runs of a case that are still to come, for the forecast of a set.
using RunsFunction = std::vector<PlannedRun> (*)(const CaseRun&);
std::vector<PlannedRun> slope_2d_runs(const CaseRun& run);
std::vector<PlannedRun> cuboid_3d_runs(const CaseRun& run);
std::vector<PlannedRun> slope_curvature_runs(const CaseRun& run);
std::vector<PlannedRun> slope_corner_runs(const CaseRun& run);

struct CaseRow {
  std::string_view name;
  std::string_view set;  ///< "paper" or "verification"
  std::string_view sentence;
  CaseFunction function;
  const ErrorProblem* problem = nullptr;  ///< null: no scalar error is swept
  RunsFunction runs = nullptr;            ///< null: not in the forecast
  bool keeps_runs = false;  ///< one by one, so that it is judged anew at no cost when resumed
};

inline constexpr std::array case_list = std::to_array<CaseRow>({
    {"slope_2d", "paper", "Cohesive slope in plane strain, strength cut by 1.4 (sample 1).",
     slope_2d, &slope_2d_problem, slope_2d_runs},
    {"cuboid_3d", "paper", "Collapse of a granular cuboid behind a gate (sample 2).", cuboid_3d,
     &cuboid_3d_problem, cuboid_3d_runs, true},
    {"slope_curvature", "paper", "Concave, straight and convex slopes in 3D (case 1).",
     slope_curvature, nullptr, slope_curvature_runs, true},
    {"slope_corner", "paper", "Slopes that turn a concave and a convex corner (case 2).",
     slope_corner, nullptr, slope_corner_runs, true},
    {"oedometer", "verification", "Elastic column between smooth walls under its own weight.",
     oedometer, &oedometer_problem},
    {"elastic_wave", "verification", "Standing longitudinal wave in a confined elastic bar.",
     elastic_wave, &elastic_wave_problem},
    {"patch", "verification", "Linear velocity field and uniform stress on a free block.", patch},
    {"disc_rotation", "verification", "Free elastic disc in rotation, one turn and ten.",
     disc_rotation, &disc_rotation_problem},
    {"rings", "verification", "Two rubber rings bounce: tensile instability.", rings},
    {"couette", "verification", "Elastic layer sheared between rough walls.", couette},
    {"rest", "verification", "Soil at rest against a smooth wall, active and passive pressure.",
     rest},
    {"element", "verification", "One stress point along the paths of laboratory tests.", element},
    {"footing", "verification", "Strip footing pushed into weightless soil.", footing,
     &footing_problem},
    {"vertical_cut", "verification", "Vertical cut below and above its critical height.",
     vertical_cut},
    {"column_2d", "verification", "Granular columns in plane strain against run-out laws.",
     column_2d},
    {"column_axisymmetric", "verification", "Granular cylinders against run-out laws.",
     column_axisymmetric},
    {"aluminium_bars", "verification",
     "Collapse of a stack of aluminium bars against its experiment.", aluminium_bars,
     &aluminium_bars_problem},
    {"slopes_fos", "verification", "Factors of safety of three published slopes.", slopes_fos},
    {"circular_footing", "verification", "Smooth circular footing pushed into heavy soil.",
     circular_footing},
    {"retrogression", "verification", "Slide after slide in a slope of softening clay.",
     retrogression},
    {"beam", "verification", "Elastic beams with free faces swing and sag.", beam, &beam_problem},
    {"askew", "verification", "Walls and slopes turned against the lattice.", askew,
     &askew_problem},
});

/// Cases and sets by name ("paper", "verification", "all"), each case once, in the order asked for.
/// Errors: Error naming what exists.
std::vector<const CaseRow*> select_cases(const std::vector<std::string>& names);

}  // namespace scarp::validation
