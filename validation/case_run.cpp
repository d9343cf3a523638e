// SPDX-License-Identifier: BSD-3-Clause
/// Scenes, stepping and cost of the cases.

#include "validation/case_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <system_error>

#include "engine/check/stability_margin.hpp"
#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "engine/run/run.hpp"
#include "engine/scene/scene_reader.hpp"

namespace scarp::validation {
namespace {

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Of all threads of this program.
double cpu_now_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Nothing that soil does is faster than sound in it.
void demand_subsonic(const StepReport& last, double sound) {
  if (last.max_velocity <= sound) return;
  throw SimulationInstability(
      fmt::format("step {}: the fastest particle moves at {:.3g} m/s, faster than sound in the "
                  "material ({:.3g} m/s). Try a smaller CFL number.",
                  last.step, last.max_velocity, sound));
}

const char* form_name(Form form) {
  return form == Form::short_form ? "short" : form == Form::main ? "main" : "full";
}

}  // namespace

std::string options_key(const CaseOptions& options) {
  return fmt::format("scarp {}, {} form, preset {}, precision {}, spacing {}, isa {}",
                     program_version(), form_name(options.form), options.preset, options.precision,
                     options.spacing, options.run.isa);
}

std::filesystem::path data_folder() {
  namespace fs = std::filesystem;
  if (const char* chosen = std::getenv("SCARP_VALIDATION"); chosen && *chosen) return chosen;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed = program.parent_path().parent_path() / "share/scarp/validation";
  return !error && fs::exists(installed, error) ? installed : fs::path(SCARP_VALIDATION_SOURCE);
}

CaseRun::CaseRun(std::string case_name, CaseOptions options) : options_(std::move(options)) {
  folder_ = options_.out / case_name;
  make_output_folder(folder_);
  std::error_code error;
  if (std::filesystem::exists(folder_ / "run.json", error)) {
    throw FileError(
        fmt::format("'{}': holds a run of 'scarp run', which the case would replace. Try "
                    "another folder with -o, or remove this one.",
                    folder_.string()));
  }
  result_.case_name = std::move(case_name);
  result_.form = form_name(options_.form);
  result_.options = options_key(options_);
  start_s_ = now_s();
}

Scene CaseRun::scene(const Spacings& spacings) const {
  const double own = options_.form == Form::short_form ? spacings.short_form
                     : options_.form == Form::main     ? spacings.main
                                                       : spacings.full;
  return scene_at(options_.spacing > 0.0 ? options_.spacing : own, options_.preset);
}

Scene CaseRun::scene_at(double spacing, const std::string& preset) const {
  return scene_at(spacing, preset, result_.case_name + ".toml");
}

Scene CaseRun::scene_at(double spacing, const std::string& preset, const std::string& file) const {
  Scene scene = read_scene(data_folder() / "cases" / result_.case_name / file, {preset, spacing});
  if (!options_.precision.empty())
    scene.numerics.precision = options_.precision == "mixed" ? Precision::mixed : Precision::real64;
  return scene;
}

std::vector<std::string> CaseRun::presets() const {
  if (!options_.preset.empty()) return {options_.preset};
  return {"modern", "paper"};
}

std::vector<double> CaseRun::spacings(const std::vector<double>& coarse_to_fine) const {
  if (options_.spacing > 0.0) return {options_.spacing};
  const std::size_t most = options_.form == Form::short_form ? 1
                           : options_.form == Form::main     ? 2
                                                             : coarse_to_fine.size();
  return {coarse_to_fine.begin(), coarse_to_fine.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                               most, coarse_to_fine.size()))};
}

Simulation CaseRun::solve(const std::string& name, const Scene& scene,
                          const std::function<void(const Simulation&)>& each_step) {
  Simulation simulation(scene, options_.run);
  while (!simulation.finished()) run_stage(name, simulation, nullptr, each_step);
  return simulation;
}

void CaseRun::announce(const std::string& name, const Simulation& simulation) const {
  if (options_.quiet || !options_.names_runs) return;
  fmt::print(stderr, "{}: {}, {} particles\n", result_.case_name, name, simulation.soil_count());
}

void CaseRun::run_stage(const std::string& name, Simulation& simulation, RunWriter* writer,
                        const std::function<void(const Simulation&)>& each_step,
                        CheckpointWriter* checkpoints) {
  announce(name, simulation);
  cli::Progress progress(total_duration(simulation.scene()), options_.quiet, options_.whole);
  const double start = now_s(), cpu_start = cpu_now_s();
  const StepReport before = simulation.last_step();
  const auto book = [&] {
    const StepReport& after = simulation.last_step();
    const std::uint64_t steps = after.step - before.step;
    result_.runs.push_back(
        {name, steps, static_cast<double>(steps) * static_cast<double>(simulation.soil_count()),
         after.time - before.time, now_s() - start, cpu_now_s() - cpu_start,
         static_cast<double>(simulation.memory_bytes())});
    progress.end();
  };
  const double sound = sound_speed(simulation.scene());
  const auto after_step = [&](const Simulation& now) {
    if (options_.stop_when_supersonic) demand_subsonic(now.last_step(), sound);
    if (each_step) each_step(now);
    progress.update(now);
    return true;
  };
  const auto stage_is_over = [before](const Simulation& now) {
    return now.last_step().step > before.step && now.stage_ended();
  };
  const auto warn = [&progress](const std::string& words) {
    progress.end();
    fmt::print(stderr, "warning: {}\n", words);
  };
  try {
    run(simulation, {.writer = writer,
                     .checkpoints = checkpoints,
                     .until = stage_is_over,
                     .after_step = after_step,
                     .warn = warn});
  } catch (...) {
    book();
    throw;
  }
  book();
  result_.stages.push_back({name, simulation.last_step().time, simulation.last_step().step,
                            simulation.stage_reached_rest()});
}

void CaseRun::finish(const Simulation* simulation, const std::string& failure) {
  result_.failure = failure;
  if (simulation != nullptr) {
    // The last run may be of another file, or of another case's scene.
    const std::string& name = result_.case_name;
    const std::filesystem::path own = data_folder() / "cases" / name / (name + ".toml");
    std::error_code error;
    if (std::filesystem::exists(own, error)) result_.title = read_scene(own, {}).title;
  }
  double particle_steps = 0.0, stepping = 0.0;
  for (const RunCost& run : result_.runs) {
    particle_steps += run.particle_steps;
    stepping += run.wall_s;
  }
  result_.wall_s = std::max(now_s() - start_s_, stepping);  // with what earlier calls have run
  add(reported("run time", result_.wall_s, "s", "the whole case, this machine and thread count"));
  if (stepping > 0.0) add(reported("particle-steps per second", particle_steps / stepping, "1/s"));
  write_case_results(folder_ / "results.json", simulation, result_);
}

}  // namespace scarp::validation
