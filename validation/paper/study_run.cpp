// SPDX-License-Identifier: BSD-3-Clause
/// Runs with checkpoints and an outcome.

#include "validation/paper/study_run.hpp"

#include <fmt/format.h>

#include "engine/checkpoint/scene_text.hpp"
#include "engine/errors.hpp"
#include "engine/output/checkpoint_file.hpp"
#include "engine/output/folder_lock.hpp"
#include "engine/run/checkpoint_writer.hpp"
#include "validation/acceptance.hpp"
#include "validation/error_time/run_log.hpp"
#include "validation/paper/set_forecast.hpp"

namespace scarp::validation {
namespace {

namespace fs = std::filesystem;

struct Begun {
  Simulation simulation;
  RunWriter writer;
};

Begun begin(const Scene& scene, const RunOptions& options, const fs::path& folder) {
  remove_checkpoints(folder);
  Simulation simulation(scene, options);
  RunWriter writer(simulation, folder);
  return {std::move(simulation), std::move(writer)};
}

Begun go_on_or_begin(const Scene& scene, const RunOptions& options, const fs::path& folder) {
  for (const fs::path& checkpoint : checkpoints_in(folder)) {
    try {
      const Snapshot snapshot = read_checkpoint(checkpoint);
      Simulation simulation(scene, snapshot, options);
      RunWriter writer(simulation, folder, snapshot);
      return {std::move(simulation), std::move(writer)};
    } catch (const CheckpointError& error) {
      fmt::print(stderr, "warning: {}: {}\n", checkpoint.string(), error.what());
      fs::remove(checkpoint);  // later ones would count as older
    }
  }
  return begin(scene, options, folder);
}

void step_to_the_end(CaseRun& run, const StudyRun& study, const Observer& observer, Begun& begun,
                     Outcome& outcome) {
  Simulation& simulation = begun.simulation;
  const fs::path folder = run.folder() / study.folder;
  CheckpointWriter checkpoints(simulation, begun.writer);
  const auto each_step = [&](const Simulation& now) {
    const std::size_t known = outcome.values.size();
    if (observer.each_step) observer.each_step(now, outcome);
    if (observer.stage_is_over && observer.stage_is_over(now)) simulation.end_stage();
    if (outcome.values.size() != known) write_outcome(folder, outcome);
  };
  bool ended = simulation.stage_ended();  // a checkpoint may be of a stage's last step
  std::size_t next = simulation.stage_index();
  do {
    if (!ended) {
      const auto& stages = simulation.scene().stages;
      try {
        run.run_stage(fmt::format("{}: {}", study.name, stages[next].name), simulation,
                      &begun.writer, each_step, &checkpoints);
      } catch (const Stopped&) {
        outcome.costs.push_back(run.result().runs.back());
        write_outcome(folder, outcome);
        throw;
      }
      outcome.costs.push_back(run.result().runs.back());
    }
    observer.stage_end(simulation, outcome);
    write_outcome(folder, outcome);
    ended = false;
    next = simulation.stage_index() + 1;
  } while (!simulation.finished());
  begun.writer.finish(simulation, 0.0);
}

}  // namespace

std::string outcome_key(const Scene& scene) {
  std::string text = program_version() + '\n' + scene_text(scene);
  for (const Probe& probe : scene.probes) {
    text += fmt::format("{} {} {} {}\n", probe.name, probe.at[0], probe.at[1], probe.at[2]);
  }
  return hash_of(text);
}

bool is_finished(const CaseRun& run, const StudyRun& study) {
  const std::optional<Outcome> left = read_outcome(run.folder() / study.folder);
  return left && left->complete && left->key == outcome_key(study.scene);
}

Outcome outcome_of(CaseRun& run, const StudyRun& study, const Observer& observer) {
  const fs::path folder = run.folder() / study.folder;
  const FolderLock lock(folder);
  Outcome outcome{study.name, study.folder, outcome_key(study.scene), false, {}, {}};
  const std::optional<Outcome> left = run.options().resume ? read_outcome(folder) : std::nullopt;
  const bool same = left && left->key == outcome.key;
  if (same) {
    outcome = *left;
    for (const RunCost& cost : outcome.costs) run.add(cost);
  }
  if (outcome.complete) {
    if (!run.options().quiet)
      fmt::print(stderr, "{}: {}, kept\n", run.result().case_name, study.name);
    return outcome;
  }
  if (run.options().forecast != nullptr)
    run.set_whole(run.options().forecast->begin(run.result().case_name, study.name));
  try {
    Begun begun = same ? go_on_or_begin(study.scene, run.options().run, folder)
                       : begin(study.scene, run.options().run, folder);
    write_outcome(folder, outcome);
    step_to_the_end(run, study, observer, begun, outcome);
  } catch (const SimulationInstability& instability) {
    run.add(holds(fmt::format("{} reaches its end", study.name), false, instability.what()));
  }
  outcome.complete = true;
  write_outcome(folder, outcome);
  remove_checkpoints(folder);
  if (run.options().forecast != nullptr)
    run.options().forecast->end(run.result().case_name, study.name);
  return outcome;
}

}  // namespace scarp::validation
