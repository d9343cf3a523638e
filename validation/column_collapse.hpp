// SPDX-License-Identifier: BSD-3-Clause
/// Granular columns that collapse on a rough base: how they are run and what is measured.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "validation/case_run.hpp"
#include "validation/deposit.hpp"

namespace scarp::validation {

/// A column of height a L0 (2D: half width L0; 3D: radius L0).
struct Column {
  double aspect_ratio = 1.0;    ///< a = H0/L0
  double friction_angle = 0.0;  ///< [deg]; 0: the scene's
};

/// Over L0: 2.5 mm in the columns of 0.1 m, a coarse grain. Chosen; the experiments' are not known.
inline constexpr double grain_size = 1.0 / 40.0;

/// What is left of a column; lengths over L0 = initial (half) width or radius.
struct ColumnDeposit {
  std::string preset;
  double spacing = 0.0;            ///< [m]
  double width = 0.0;              ///< L0 [m]
  Column column;                   ///< with the friction angle it had
  double run_out = 0.0;            ///< (L - L0)/L0 with L the 99.5 % quantile of the volume
  double advance = 0.0;            ///< of that in the last sqrt(H0/g)
  double grain_run_out = 0.0;      ///< the same to where the deposit is one grain high
  double connected_run_out = 0.0;  ///< the same to the end of the connected deposit
  double height = 0.0;             ///< at the symmetry plane or axis
  double lost = 0.0;               ///< share of the soil that went through a wall
  double viscous_share = 0.0;      ///< `viscous_share` of the collapse
};

/// Share of the artificial viscosity in the energy that a stage has dissipated; 0 where none was,
/// or where the scene does not sum it.
double viscous_share(const Simulation& simulation);

/// Fits a scene to a column: the height of its first body (a box, or a height field of constant
/// height over a radius), its friction angle, and the duration of its last stage, 6 sqrt(H0/g).
void set_column(Scene& scene, Column& column);

/// Runs the scene through its stages and measures the deposit; `surface` receives the profile in
/// 2D; both may be null. Errors: those of `CaseRun::run_stage`.
ColumnDeposit collapse_column(CaseRun& run, const std::string& name, Simulation& simulation,
                              const Column& column, RunWriter* writer = nullptr,
                              Profile* surface = nullptr);

/// A run-out law of experiments: factor a below the transition, factor a^exponent above.
struct RunOutLaw {
  double transition, below, above, exponent;
  double at(double aspect_ratio) const;
};

/// The two laws between which a run-out must lie, and up to which aspect ratio it is judged.
struct LawBand {
  RunOutLaw lube, lajeunesse;
  std::string source;
  double largest_judged = 0.0;
  std::string over_run;  ///< what is expected over Lube's law, in words
};

/// Which columns are run.
struct ColumnPlan {
  std::vector<double> spacings;       ///< coarse to fine, for columns as high as wide or higher [m]
  std::vector<double> aspect_ratios;  ///< those above the largest judged at one spacing fewer
  double height_kept_to = 0.0;        ///< aspect ratio up to which the top stays; 0: not judged
  double control_aspect_ratio = 1.0;  ///< of the column of 65 deg that must miss the band
};

/// Runs the columns of a case at both presets and the spacings of its form, judges them against
/// the laws, and leaves run_out.csv, one surface_*.csv per column (2D), and the frames of one.
/// Errors: those of `CaseRun::run_stage`.
void judge_columns(CaseRun& run, const ColumnPlan& plan, const LawBand& laws);

}  // namespace scarp::validation
