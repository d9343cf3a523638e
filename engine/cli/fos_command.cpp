// SPDX-License-Identifier: BSD-3-Clause
/// `scarp fos`: settles a scene once, cuts its strength by different factors, shows how it fails.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>

#include "engine/cli/commands.hpp"
#include "engine/cli/folder_claim.hpp"
#include "engine/cli/fos_output.hpp"
#include "engine/cli/interrupt.hpp"
#include "engine/cli/progress.hpp"
#include "engine/errors.hpp"
#include "engine/fos/failure_run.hpp"
#include "engine/initial_stress_check.hpp"
#include "engine/output/folder_lock.hpp"
#include "engine/output/text_file.hpp"
#include "engine/scene/nearest_name.hpp"
#include "engine/scene/warnings.hpp"

namespace scarp::cli {
namespace {

namespace fs = std::filesystem;

CriterionOptions criterion_options(const FosArguments& arguments, const Scene& scene) {
  CriterionOptions options;
  if (!arguments.height.empty())
    options.height = positive_option("--height", arguments.height, "m", kernels::Unit::length);
  if (!arguments.window.empty())
    options.window = positive_option("--window", arguments.window, "s", kernels::Unit::time);
  if (!arguments.ramp.empty()) {
    options.ramp = option_value("--ramp", arguments.ramp, "s", kernels::Unit::time);
    if (!(options.ramp >= 0.0)) throw UsageError("--ramp: it is below 0. Try \"0 s\": at once.");
  }
  options.probe = arguments.probe;
  std::vector<std::string> names;
  for (const Probe& probe : scene.probes) names.push_back(probe.name);
  if (!options.probe.empty() &&
      std::find(names.begin(), names.end(), options.probe) == names.end()) {
    throw UsageError(fmt::format("--probe: the scene has no probe '{}'. {}", options.probe,
                                 did_you_mean(options.probe, names)));
  }
  return options;
}

SearchOptions search_options(const FosArguments& arguments) {
  if (arguments.to && !(*arguments.to > arguments.from)) {
    throw UsageError(fmt::format("--to: {:g} is not above --from {:g}. Try a larger one.",
                                 *arguments.to, arguments.from));
  }
  return {arguments.from, arguments.to, arguments.tolerance};
}

/// A progress bar for each trial, begun at its first step.
class TrialProgress {
 public:
  explicit TrialProgress(bool quiet) : quiet_(quiet) {}
  bool operator()(const Simulation& now) {
    if (!bar_) bar_.emplace(total_duration(now.scene()), quiet_);
    bar_->update(now);
    return !stop_requested();
  }
  void end() {
    if (bar_) bar_->end();
    bar_.reset();
  }

 private:
  bool quiet_;
  std::optional<Progress> bar_;
};

void write_outputs(const FosReport& report, const Simulation& settled, const fs::path& folder,
                   const FosArguments& arguments) {
  const std::string json = fos_json(report, settled);
  replace_file(folder / "fos.json", json);
  if (arguments.scene.json != "-") fmt::print("{}", fos_text(report, settled));
  if (!arguments.scene.json.empty()) write_text(arguments.scene.json, json);
  std::fflush(stdout);
}

fs::path output_folder(const FosArguments& arguments, const Scene& scene) {
  return arguments.folder.empty()
             ? fs::path("out") / (fs::path(scene.file).stem().string() + "_fos")
             : fs::path(arguments.folder);
}

/// Settles, with as much strength as the slope needs for it, and with the cost of all attempts.
std::optional<StrengthReduction> settle(const Scene& scene, const FosArguments& arguments,
                                        FosReport& report, TrialProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  std::optional<StandingSlope> standing =
      settle_standing(scene, arguments.scene.options, report.criterion, std::ref(progress),
                      [&](double strengthening) {
                        progress.end();
                        if (arguments.quiet) return;
                        fmt::print(stderr,
                                   "the slope fails with the strength it settles with: once more "
                                   "from the start, with {:g} times the scene's\n",
                                   strengthening);
                      });
  progress.end();
  if (!standing) return {};
  report.strengthening = standing->strengthening;
  report.settle_time = standing->settle_time;
  report.settled_at_rest = standing->slope.settled().stage_reached_rest();
  const double elastic = standing->slope.elastic() ? standing->slope.elastic()->wall_s : 0.0;
  report.settle_wall_s =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() - elastic;
  return std::move(standing->slope);
}

/// What is begun, from the scene as it starts.
void announce(const Scene& scene, const FosArguments& arguments, const fs::path& folder) {
  const Simulation start(scene, arguments.scene.options);
  for (const std::string& warning : initial_stress_warnings(start))
    fmt::print(stderr, "warning: {}\n", warning);
  if (arguments.quiet) return;
  fmt::print(stderr, "{}: {} soil and {} wall particles, {}, {} threads, output in {}\n",
             scene.title.empty() ? arguments.scene.file : scene.title, start.soil_count(),
             start.wall_count(), start.isa(), start.threads(), folder.string());
}

}  // namespace

int fos_command(const FosArguments& arguments) {
  const Scene scene = load_scene(arguments.scene);
  const SearchOptions search = search_options(arguments);
  const CriterionOptions options = criterion_options(arguments, scene);
  check_reducible(scene);
  FosReport report;
  report.criterion = choose_criterion(scene, options);
  for (const std::string& warning : warnings(scene)) fmt::print(stderr, "warning: {}\n", warning);
  const fs::path folder = output_folder(arguments, scene);
  const FolderLock lock(folder);
  claim_folder(folder, Command::fos, scene, arguments.overwrite);
  announce(scene, arguments, folder);
  catch_interrupts();
  TrialProgress progress(arguments.quiet);
  std::optional<StrengthReduction> standing = settle(scene, arguments, report, progress);
  if (!standing) return interrupted;
  StrengthReduction& slope = *standing;
  CsvFile table(folder / "fos.csv", trial_titles());
  const auto done = [&](const FactorOfSafety& found, const Trial& trial) {
    progress.end();
    report.found = found;
    report.criterion = slope.criterion();
    if (found.trials.empty()) return;  // the elastic response
    for (const double cell : trial_cells(trial)) table << cell;
    table.end_row();
    if (!arguments.quiet) fmt::print(stderr, "{}\n", trial_sentence(trial, found.bracket));
  };
  try {
    report.found = find_factor(slope, search, std::ref(progress), done);
    progress.end();
    if (stop_requested()) report.failure = "stopped on request";
    if (report.failure.empty() && report.found.bracket.fails) {
      run_failure(slope, *report.found.bracket.fails, folder / "failure", std::ref(progress));
      progress.end();
    }
  } catch (const SimulationInstability& instability) {  // what is known stays
    progress.end();
    report.failure = instability.what();
    write_outputs(report, slope.settled(), folder, arguments);
    throw;
  }
  write_outputs(report, slope.settled(), folder, arguments);
  if (stop_requested()) return interrupted;
  try {  // without Python the numbers are there all the same
    report_command(folder.string(), arguments.scene.json == "-");
  } catch (const FileError& error) {
    fmt::print(stderr, "no report: {}\n", error.what());
  }
  return report.found.bracket.complete ? ok : failed;
}

}  // namespace scarp::cli
