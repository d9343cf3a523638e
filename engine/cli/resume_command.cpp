// SPDX-License-Identifier: BSD-3-Clause
/// `scarp resume`: a run goes on from its newest checkpoint that is whole.

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "engine/checkpoint/scene_text.hpp"
#include "engine/cli/commands.hpp"
#include "engine/cli/drive.hpp"
#include "engine/cli/resumed_run.hpp"
#include "engine/cli/run_record.hpp"
#include "engine/errors.hpp"
#include "engine/output/folder_lock.hpp"
#include "engine/output/results.hpp"
#include "engine/plain_text.hpp"
#include "engine/run/checkpoint_writer.hpp"
#include "engine/team.hpp"

namespace scarp::cli {
namespace {

namespace fs = std::filesystem;

/// The run has its scene from the record; who has edited a file may believe otherwise.
void say_what_has_changed(const RunRecord& record, const Scene& scene, const fs::path& folder) {
  if (const std::string change = change_of_scene(record, scene); !change.empty()) {
    fmt::print(stderr,
               "warning: {} Here goes on the scene that the run began with. To run the other: "
               "scarp run {} -o {} --overwrite\n",
               change, plain_text(record.scene_name), plain_text(folder.string()));
  }
}

/// The copy of the scene is written again; one that somebody has worked on is not lost by it.
void put_edited_copy_aside(const RunRecord& record, const fs::path& folder,
                           const std::string& scene) {
  const fs::path copy = folder / "scene.toml";
  std::error_code ignored;
  const bool in_use = fs::equivalent(copy, record.scene_name, ignored) ||
                      (!scene.empty() && fs::equivalent(copy, scene, ignored));
  if (in_use || !fs::exists(copy, ignored) || read_text(copy) == record.scene_text) return;
  const fs::path aside = folder / "scene_edited.toml";
  fs::rename(copy, aside, ignored);
  fmt::print(stderr,
             "warning: '{}' was not the scene of this run; it is now '{}', and changes nothing.\n",
             plain_text(copy.string()), plain_text(aside.string()));
}

/// The scene with more stages. Errors: SceneError that names the first other difference.
Scene longer_scene(const std::string& file, const RunRecord& record, const Scene& recorded) {
  Scene longer = read_scene(file, record.overrides);
  const std::string before = scene_text(recorded), now = scene_text(longer);
  const std::string outputs = first_difference(output_text(recorded), output_text(longer));
  if (only_adds_stages(before, now) && outputs.empty()) return longer;
  throw SceneError(fmt::format(
      "{}: it is not the scene of the run with more stages behind the last one: there {}. Try a "
      "copy of the run's scene.toml with more [[stage]] at its end.",
      file, only_adds_stages(before, now) ? outputs : first_difference(before, now)));
}

bool go_on_is_needed(const fs::path& folder, bool more_stages) {
  if (more_stages || !run_is_finished(folder)) return true;
  fmt::print(stderr,
             "{}: the run is {}; there is nothing to go on with. More stages: scarp resume "
             "{} --scene LONGER.toml\n",
             plain_text(folder.string()),
             run_lost_soil(folder) ? "over, but lost soil" : "complete",
             plain_text(folder.string()));
  return false;
}

void warn_of_another_program(const RunRecord& record) {
  if (record.program == program_version()) return;
  fmt::print(stderr, "warning: begun by scarp {}, which may not give the same bits as {}.\n",
             record.program, program_version());
}

void say_where(const ResumedRun& resumed, const fs::path& folder, bool over) {
  const StepReport& last = resumed.simulation.last_step();
  fmt::print(stderr, "{}: {} at step {}, {:.4g} s, {}, {} threads\n", plain_text(folder.string()),
             over ? "no checkpoint, starts over" : "goes on", last.step, last.time,
             resumed.simulation.isa(), resumed.simulation.threads());
}

/// As many as it was begun with, or what there is here: results do not depend on it.
std::optional<int> threads_of(const RunRecord& record) {
  if (!record.threads || complaint_about_threads(*record.threads).empty()) return record.threads;
  const int here = default_threads();
  fmt::print(stderr,
             "warning: begun with {} threads; there are {} here, which changes no result.\n",
             *record.threads, here);
  return here;
}

}  // namespace

int resume_command(const ResumeArguments& arguments) {
  require_target("--json", arguments.json, {});
  RunToResume run;
  run.folder = arguments.folder;
  RunRecord record = read_record(run.folder);
  const FolderLock lock(run.folder);
  run.scene = read_scene_text(record.scene_text, record.scene_name, record.overrides);
  bool more_stages = false;
  if (arguments.scene.empty()) {
    say_what_has_changed(record, run.scene, run.folder);
  } else {
    const std::size_t stages = run.scene.stages.size();
    run.scene = longer_scene(arguments.scene, record, run.scene);
    more_stages = run.scene.stages.size() > stages;
  }
  put_edited_copy_aside(record, run.folder, arguments.scene);
  if (!go_on_is_needed(run.folder, more_stages)) return run_lost_soil(run.folder) ? lost_soil : ok;
  if (more_stages && run_is_finished(run.folder) && checkpoints_in(run.folder).empty()) {
    throw CheckpointError(fmt::format(
        "'{}': the run left no checkpoint of its end, from which more stages could go on. Try "
        "[checkpoint] in the scene, and scarp run.",
        run.folder.string()));
  }
  warn_of_another_program(record);
  run.options = arguments.options;
  if (run.options.isa.empty()) run.options.isa = record.isa;
  if (!run.options.threads) run.options.threads = threads_of(record);
  if (arguments.accept_tables) run.tables = OldTables::as_they_are;
  std::optional<ResumedRun> resumed =
      go_on(run, [](const std::string& words) { fmt::print(stderr, "warning: {}\n", words); });
  const bool over = !resumed;
  if (over) resumed.emplace(start_over(run));
  if (more_stages) {
    record.scene_name = run.scene.file;
    record.scene_text = run.scene.text;
    write_record(run.folder, record);
  }
  for (const std::string& warning : resumed->writer.warnings())
    fmt::print(stderr, "warning: {}\n", warning);
  if (!arguments.quiet) say_where(*resumed, run.folder, over);
  return saying_how_to_go_on(run.folder, [&] {
    return drive(resumed->simulation, resumed->writer, std::move(resumed->recovery),
                 {arguments.json, arguments.quiet});
  });
}

}  // namespace scarp::cli
