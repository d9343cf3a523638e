// SPDX-License-Identifier: BSD-3-Clause
/// `scarp fos`: settles a scene once, cuts its strength by different factors, shows how it fails.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>

#include "engine/check/start_warnings.hpp"
#include "engine/check/warnings.hpp"
#include "engine/cli/commands.hpp"
#include "engine/cli/folder_claim.hpp"
#include "engine/cli/fos_forecast.hpp"
#include "engine/cli/fos_output.hpp"
#include "engine/cli/fos_record.hpp"
#include "engine/cli/fos_settle.hpp"
#include "engine/cli/run_record.hpp"
#include "engine/errors.hpp"
#include "engine/fos/failure_run.hpp"
#include "engine/output/folder_lock.hpp"
#include "engine/output/text_file.hpp"
#include "engine/plain_text.hpp"
#include "engine/run/checkpoint_writer.hpp"
#include "engine/run/run.hpp"
#include "engine/scene/nearest_name.hpp"

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
    if (!(*options.ramp >= 0.0)) throw UsageError("--ramp: it is below 0. Try \"0 s\": at once.");
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

/// What is begun, from the scene as it starts.
void announce(const Simulation& start, const FosArguments& arguments, const fs::path& folder) {
  const Scene& scene = start.scene();
  for (const std::string& warning : check::start_warnings(start))
    fmt::print(stderr, "warning: {}\n", warning);
  if (arguments.quiet) return;
  fmt::print(stderr, "{}: {} soil and {} wall particles, {}, {} threads, output in {}\n",
             plain_text(scene.title.empty() ? arguments.scene.file : scene.title),
             start.soil_count(), start.wall_count(), start.isa(), start.threads(),
             plain_text(folder.string()));
}

/// Replaces the trial of this factor, or adds it.
void remember(SearchRecord& known, const FactorOfSafety& found, const Trial& trial) {
  known.elastic = found.elastic;
  const auto same = [&](const Trial& t) { return t.reduction == trial.reduction; };
  if (found.trials.empty() || std::any_of(known.trials.begin(), known.trials.end(), same)) return;
  known.trials.push_back(trial);
}

int search_in(const fs::path& folder, const Scene& scene, const FosArguments& arguments,
              const SearchOptions& search, FosReport report) {
  SearchRecord record;
  {
    const Simulation start(scene, arguments.scene.options);
    record = begin_search(folder, scene, search_key(start, report.criterion));
    announce(start, arguments, folder);
    if (!arguments.quiet && checkpoints_in(folder).empty())
      fmt::print(stderr, "{}\n", search_forecast(start, report.criterion, search));
  }
  write_search(folder, record);
  SearchProgress progress(&scene, report.criterion, search, arguments.quiet);
  std::optional<StrengthReduction> standing =
      settle_in(folder, scene, arguments, report, record, progress);
  if (!standing) throw Stopped();
  StrengthReduction& slope = *standing;
  CsvFile table(folder / "fos.csv", trial_titles());
  if (!arguments.quiet && !record.trials.empty())
    fmt::print(stderr, "{} trials are known from before\n", record.trials.size());
  const auto done = [&](const FactorOfSafety& found, const Trial& trial) {
    progress.end();
    progress.learn(found);
    report.found = found;
    report.criterion = slope.criterion();
    remember(record, found, trial);
    write_search(folder, record);
    if (found.trials.empty()) return;  // the elastic response
    for (const double cell : trial_cells(trial)) table << cell;
    table.end_row();
    if (arguments.quiet) return;
    const std::string left = time_left(search, found);
    fmt::print(stderr, "{}{}{}\n", trial_sentence(trial, found.bracket), left.empty() ? "" : "; ",
               left);
  };
  const auto end_search = [&] {
    record.ended = true;
    write_search(folder, record);
  };
  const auto keep_what_is_known = [&] {
    progress.end();
    report.failure = reason_of(std::current_exception());
    write_outputs(report, slope.settled(), folder, arguments);
  };
  const std::vector<Trial> known = record.trials;
  try {
    report.found = find_factor(slope, search, std::ref(progress), done, known);
    progress.end();
    const std::optional<double> fails = report.found.bracket.fails;
    const bool shown = fails && record.failure_run == fails && run_is_finished(folder / "failure");
    if (fails && !shown) {
      progress.show_failure();
      const bool whole = run_failure(slope, *fails, folder / "failure", std::ref(progress));
      progress.end();
      if (whole) record.failure_run = fails;
    }
  } catch (const SceneError&) {  // nothing to go on with
    end_search();
    throw;
  } catch (const SimulationInstability&) {
    keep_what_is_known();
    end_search();
    throw;
  } catch (...) {
    keep_what_is_known();
    throw;
  }
  write_outputs(report, slope.settled(), folder, arguments);
  end_search();
  try {  // without Python the numbers are there all the same
    report_command({.folder = folder.string(),
                    .quiet = arguments.quiet,
                    .silent = arguments.scene.json == "-"});
  } catch (const FileError& error) {
    fmt::print(stderr, "no report: {}\n", error.what());
  }
  return report.found.bracket.complete ? ok : failed;
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
  try {
    return search_in(folder, scene, arguments, search, std::move(report));
  } catch (const SceneError&) {
    throw;
  } catch (const SimulationInstability&) {
    throw;
  } catch (...) {
    fmt::print(stderr, "What has been found is in {}. To go on: the same command again.\n",
               plain_text(folder.string()));
    throw;
  }
}

}  // namespace scarp::cli
