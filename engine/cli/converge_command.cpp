// SPDX-License-Identifier: BSD-3-Clause
/// `scarp converge`: a scene at three spacings, coarse first, what is already there not run again.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/check/warnings.hpp"
#include "engine/cli/commands.hpp"
#include "engine/cli/converge_output.hpp"
#include "engine/cli/folder_claim.hpp"
#include "engine/cli/progress.hpp"
#include "engine/converge/study.hpp"
#include "engine/errors.hpp"
#include "engine/output/folder_lock.hpp"
#include "engine/output/numerics_json.hpp"
#include "engine/output/run_writer.hpp"
#include "engine/output/text_file.hpp"
#include "engine/plain_text.hpp"
#include "engine/run/run.hpp"
#include "engine/scene/units.hpp"

namespace scarp::cli {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Coarse to fine. Errors: UsageError for spacings that no order can be told from.
std::array<double, 3> chosen_spacings(const ConvergeArguments& arguments, double own) {
  std::array<double, 3> spacings{4.0 * own, 2.0 * own, own};
  if (!arguments.spacings.empty()) {
    std::transform(arguments.spacings.begin(), arguments.spacings.end(), spacings.begin(),
                   [](const std::string& text) {
                     const std::size_t first = text.find_first_not_of(' ');
                     return option_value("--spacings",
                                         first == std::string::npos ? text : text.substr(first),
                                         "m", kernels::Unit::length);
                   });
  }
  std::sort(spacings.begin(), spacings.end(), std::greater<>());
  if (!(spacings[2] > 0.0) || spacings[0] < 1.1 * spacings[1] || spacings[1] < 1.1 * spacings[2]) {
    throw UsageError(
        "--spacings: three spacings above 0 are needed, each at least 1.1 times the next");
  }
  return spacings;
}

double measure_of(const Json& results, const std::string& name) {
  for (const Json& measure : results.at("measures")) {
    if (measure.at("name") == name) {
      const Json& value = measure.at("value");
      return value.is_null() ? NAN : value.get<double>();
    }
  }
  throw FileError(fmt::format("no measure '{}'", name));
}

SpacingRun run_of(const Json& results, const std::vector<EndQuantity>& quantities) {
  SpacingRun run;
  run.spacing = results.at("spacing").get<double>();
  run.wall_s = results.at("wall_s").get<double>();
  run.particles = results.at("particles").get<double>();
  run.steps = results.at("steps").get<double>();
  run.mass = measure_of(results, "mass");
  for (const EndQuantity& quantity : quantities) {
    run.values.push_back(measure_of(results, quantity.name));
  }
  return run;
}

/// The run that a folder holds, if it is complete and of this scene, these options and this
/// program. Threads count as well: run times are compared.
std::optional<SpacingRun> earlier_run(const fs::path& folder, const Simulation& simulation,
                                      const std::vector<EndQuantity>& quantities) {
  const Scene& scene = simulation.scene();
  try {
    if (read_text(folder / "scene.toml") != scene.text) return {};
    const Json results = Json::parse(read_text(folder / "results.json"));
    const bool same = results.at("complete") == true && results.at("spacing") == scene.spacing &&
                      results.at("preset") == scene.numerics.preset &&
                      results.at("numerics") == Json(numerics_json(scene)) &&
                      results.at("isa") == simulation.isa() &&
                      results.at("threads") == simulation.threads() &&
                      results.at("particles") == simulation.soil_count() &&
                      results.at("versions").at("scarp") == program_version();
    if (!same) return {};
    SpacingRun run = run_of(results, quantities);
    run.reused = true;
    return run;
  } catch (const std::exception&) {  // missing, half written, or of another program: run again
    return {};
  }
}

/// The runs at finer spacings take what this one takes, scaled by the cost of a spacing.
WholeWork runs_from(std::size_t now, const std::array<double, 3>& spacings, int dimension) {
  return {fmt::format("spacing {} of 3", now + 1), [=](double run_s) {
            double ahead = 0.0;
            for (std::size_t k = now + 1; k < spacings.size(); ++k)
              ahead += forecast_wall(run_s, spacings[now], spacings[k], dimension);
            return ahead;
          }};
}

/// Runs to the end; without one the outputs are marked incomplete.
void run_to_end(Simulation& simulation, const fs::path& folder,
                const std::vector<EndQuantity>& quantities, bool quiet, const WholeWork& whole) {
  RunWriter writer(simulation, folder);
  Progress progress(total_duration(simulation.scene()), quiet, whole);
  const auto after_step = [&](const Simulation& now) {
    progress.update(now);
    if (now.finished()) {
      std::vector<Measure> measures = basic_measures(now);
      const std::vector<double> values = end_values(now);
      for (std::size_t q = 0; q < quantities.size(); ++q) {
        const auto same = [&](const Measure& m) { return m.name == quantities[q].name; };
        if (std::any_of(measures.begin(), measures.end(), same)) continue;
        measures.push_back({quantities[q].name, values[q], quantities[q].unit, {}, {}, {}, {}});
      }
      writer.set_measures(std::move(measures));
    }
    return true;
  };
  run(simulation, {.writer = &writer, .after_step = after_step});
  progress.end();
}

/// The forecast for the spacings still to come.
std::string forecast(const SpacingRun& done, const std::array<double, 3>& spacings,
                     std::size_t next, int dimension) {
  std::string text;
  double total = 0.0;
  for (std::size_t k = next; k < spacings.size(); ++k) {
    const double wall = forecast_wall(done.wall_s, done.spacing, spacings[k], dimension);
    total += wall;
    text += fmt::format("{}{:g} m about {}", text.empty() ? "" : ", ", spacings[k],
                        readable_duration(wall));
  }
  return fmt::format("expected run time: {}; {} in all (cost as spacing^-{})", text,
                     readable_duration(total), dimension + 1);
}

int converge(const ConvergeArguments& arguments) {
  const Scene own = load_scene(arguments.scene);
  const std::array<double, 3> spacings = chosen_spacings(arguments, own.spacing);
  for (const std::string& warning : warnings(own)) fmt::print(stderr, "warning: {}\n", warning);
  const fs::path folder = arguments.folder.empty()
                              ? fs::path("out") / (fs::path(own.file).stem().string() + "_converge")
                              : fs::path(arguments.folder);
  const FolderLock lock(folder);
  claim_folder(folder, Command::converge, own, arguments.overwrite);
  const std::vector<EndQuantity> quantities = end_quantities(own);
  std::array<SpacingRun, 3> runs;
  std::string isa;
  int threads = 0;
  ExitCode code = ok;
  for (std::size_t k = 0; k < spacings.size(); ++k) {
    SceneArguments scene = arguments.scene;
    scene.spacing = fmt::format("{} m", spacings[k]);
    Simulation simulation(load_scene(scene), scene.options);
    const fs::path place = folder / fmt::format("dx_{:g}", spacings[k]);
    std::optional<SpacingRun> done = earlier_run(place, simulation, quantities);
    if (!done) {
      if (!arguments.quiet) {
        fmt::print(stderr, "spacing {:g} m: {} soil particles, output in {}\n", spacings[k],
                   simulation.soil_count(), place.string());
      }
      run_to_end(simulation, place, quantities, arguments.quiet,
                 runs_from(k, spacings, own.dimension));
      const LostSoil& lost = simulation.lost_soil();
      if (lost.particles > 0) {
        fmt::print(stderr, "warning: {}\n", lost.message(simulation.soil_count()));
        code = lost_soil;
      }
      done = run_of(Json::parse(read_text(place / "results.json")), quantities);
    }
    isa = simulation.isa();
    threads = simulation.threads();
    runs[k] = *done;
    if (arguments.quiet) continue;
    fmt::print(stderr, "spacing {:g} m: {} {}\n", spacings[k],
               done->reused ? "was there already, took" : "done in",
               readable_duration(done->wall_s));
    if (k + 1 < spacings.size()) {
      fmt::print(stderr, "{}\n", forecast(*done, spacings, k + 1, own.dimension));
    }
  }
  const Study study = assess(quantities, runs, own.dimension);
  const std::string json = study_json(study, own, isa, threads);
  replace_file(folder / "converge.json", json);
  write_study_csv((folder / "converge.csv").string(), study);
  const bool numbers_only = arguments.scene.json == "-";
  if (!numbers_only) fmt::print("{}", study_text(study));
  if (!arguments.scene.json.empty()) write_text(arguments.scene.json, json);
  std::fflush(stdout);
  try {  // without Python the numbers are there all the same
    report_command({.folder = folder.string(), .quiet = arguments.quiet, .silent = numbers_only});
  } catch (const FileError& error) {
    fmt::print(stderr, "no report: {}\n", error.what());
  }
  return code;
}

}  // namespace

int converge_command(const ConvergeArguments& arguments) {
  try {
    return converge(arguments);
  } catch (const Stopped&) {
    fmt::print(stderr, "To go on: the same command; runs that are complete are kept.\n");
    throw;
  }
}

}  // namespace scarp::cli
