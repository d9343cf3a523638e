// SPDX-License-Identifier: BSD-3-Clause
/// What every validation case is given: its options, its folder, and a way to step that counts
/// cost.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/cli/progress.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/run/checkpoint_writer.hpp"
#include "engine/simulation.hpp"
#include "validation/acceptance.hpp"

namespace scarp::validation {

class SetForecast;

/// How much of a case is run: for a quick check, as published, or finer.
enum class Form { short_form, main, full };

struct CaseOptions {
  Form form = Form::main;
  std::filesystem::path out = "out";  ///< the case's folder is made in it
  std::string preset;                 ///< in place of the scene's
  std::string precision;              ///< in place of the scene's: double, mixed
  double spacing = 0.0;               ///< in place of the form's [m]
  RunOptions run;
  bool quiet = false;
  bool resume = false;  ///< keep what an earlier call finished, go on with what it began
  SetForecast* forecast = nullptr;  ///< told of the runs of studies; may be null
  cli::WholeWork whole{};           ///< what the case is a part of
  bool names_runs = true;           ///< each run is named on standard error before its steps
  /// A run with a particle faster than sound counts as unstable. Lost grains slow a run until it
  /// would never end.
  bool stop_when_supersonic = false;
};

/// Particle spacing of each form [m].
struct Spacings {
  double short_form, main, full;
};

/// One execution of a case. Collects measures and costs; knows nothing of what is measured.
class CaseRun {
 public:
  CaseRun(std::string case_name, CaseOptions options);

  /// `validation/cases/<case>/<case>.toml` with the options applied. Errors: FileError, SceneError.
  Scene scene(const Spacings& spacings) const;

  /// The same at a spacing and preset of the case's choice; `--preset` and `--spacing` do not
  /// matter here. Errors: FileError, SceneError.
  Scene scene_at(double spacing, const std::string& preset) const;

  /// The same of another file in the case's folder. Errors: FileError, SceneError.
  Scene scene_at(double spacing, const std::string& preset, const std::string& file) const;

  /// Both presets, or the one asked for.
  std::vector<std::string> presets() const;

  /// The spacings of the form, coarse to fine; the one asked for if `--spacing` is given. The main
  /// form takes the first two, the short form the first, the full form all.
  std::vector<double> spacings(const std::vector<double>& coarse_to_fine) const;

  /// A simulation of the scene run through all its stages, its cost booked under `name`. Errors:
  /// SceneError, SimulationInstability, FileError.
  Simulation solve(const std::string& name, const Scene& scene,
                   const std::function<void(const Simulation&)>& each_step = {});

  /// Steps until the present stage ends, the steps' cost booked under `name`. Errors: those of
  /// `scarp::run`.
  void run_stage(const std::string& name, Simulation& simulation, RunWriter* writer = nullptr,
                 const std::function<void(const Simulation&)>& each_step = {},
                 CheckpointWriter* checkpoints = nullptr);

  /// Names a run that begins.
  void announce(const std::string& name, const Simulation& simulation) const;

  /// What the runs from here on are a part of.
  void set_whole(cli::WholeWork whole) { options_.whole = std::move(whole); }

  void add(Measure measure) { result_.measures.push_back(std::move(measure)); }
  /// Books a run that was not stepped by this class.
  void add(RunCost cost) { result_.runs.push_back(std::move(cost)); }
  void add(ClaimLine claim) { result_.claims.push_back(std::move(claim)); }
  void add(ConvergenceSeries series) { result_.convergence.push_back(std::move(series)); }
  const CaseOptions& options() const { return options_; }
  bool short_form() const { return options_.form == Form::short_form; }
  const std::filesystem::path& folder() const { return folder_; }
  const CaseResult& result() const { return result_; }

  /// Ends the case: the measures of cost, then results.json; `simulation` may be null if there was
  /// none. Errors: FileError.
  void finish(const Simulation* simulation, const std::string& failure = {});

 private:
  CaseOptions options_;
  std::filesystem::path folder_;
  CaseResult result_;
  double start_s_ = 0.0;
};

/// Of everything that an option can change in a case's results: version, form, preset, precision,
/// spacing, instruction set.
std::string options_key(const CaseOptions& options);

/// The folder of the cases' data: SCARP_VALIDATION, else beside an installed program, else the
/// source tree it was built from.
std::filesystem::path data_folder();

}  // namespace scarp::validation
