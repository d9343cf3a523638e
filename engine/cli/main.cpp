// SPDX-License-Identifier: BSD-3-Clause
/// The program `scarp`: options to commands, errors to exit codes.

#include <fmt/format.h>
#include <malloc.h>

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "engine/cli/commands.hpp"
#include "engine/cli/interrupt.hpp"
#include "engine/cli/options.hpp"
#include "engine/element/element_path.hpp"
#include "engine/fos/limit_search.hpp"
#include "engine/output/results.hpp"
#include "engine/team.hpp"

namespace {

using namespace scarp::cli;

CLI::App* add_element_command(CLI::App& app, ElementArguments& element) {
  CLI::App* command = app.add_subcommand(
      "element", "Drive one material point along a laboratory test and write a table");
  add_common_options(*command, element.scene);
  command->add_option("--path", element.path, "The laboratory test")
      ->required()
      ->check(CLI::IsMember(std::vector<std::string>(scarp::element_path_names.begin(),
                                                     scarp::element_path_names.end())));
  command->add_option("--material", element.material,
                      "Name of the material; default: the only one in the scene");
  command->add_option("--confining", element.confining,
                      "Pressure at the start, and of the stress that is held; default \"100 kPa\"");
  command
      ->add_option("--strain", element.strain,
                   "Strain at the end, positive in compression (simple_shear: gamma); default 0.05")
      ->check(CLI::Range(-10.0, 10.0));
  command
      ->add_option("--steps", element.steps, "Number of equal increments of strain; default 1000")
      ->check(CLI::Range(1, 10'000'000));
  command->add_option(
      "-o,--out", element.table,
      "Write the table here; default out/<name of the scene file>/element_<path>.csv");
  return command;
}

CLI::App* add_fos_command(CLI::App& app, FosArguments& fos) {
  CLI::App* command = app.add_subcommand("fos",
                                         "Find the factor of safety of a slope by cutting its "
                                         "strength by different factors, and write "
                                         "report.html");
  add_scene_options(*command, fos.scene);
  add_spacing_option(*command, fos.scene);
  command
      ->add_option(
          "--tolerance", fos.tolerance,
          "Stop when the bracket around the factor is this wide, over its middle; default 0.01")
      ->check(CLI::Range(1e-4, 1.0));
  command->add_option("--from", fos.from, "Try this strength reduction factor first; default 1")
      ->check(CLI::Range(scarp::least_reduction, scarp::most_reduction));
  command->add_option("--to", fos.to, "Try this one next if the slope stands with the first")
      ->check(CLI::Range(scarp::least_reduction, scarp::most_reduction));
  command->add_option(
      "--ramp", fos.ramp,
      "Take this time for a cut by 1.5, 0 for at once; default: 1.4 times that of a free "
      "fall over the slope's height");
  command->add_option(
      "--window", fos.window,
      "Wait this long after the cut for the slope to fail, e.g. \"4 s\"; default: five free "
      "falls");
  command->add_option("--probe", fos.probe,
                      "Judge the displacement of this probe; default: the first of the scene, and "
                      "without probes the largest displacement");
  command->add_option(
      "--height", fos.height,
      "Height of the slope, e.g. \"10 m\"; default: highest less lowest ground along gravity");
  add_folder_options(*command, fos, "_fos");
  return command;
}

int run_program(int argc, char** argv) {
  CLI::App app{"Smoothed-particle hydrodynamics for slope failure and granular collapse"};
  app.set_version_flag("--version", "scarp " + scarp::program_version());
  app.require_subcommand(1);
  app.footer(exit_codes_text);

  RunArguments run;
  CLI::App* run_app = add_run_command(app, run);

  ResumeArguments resume;
  CLI::App* resume_app = add_resume_command(app, resume);

  CheckArguments check;
  CLI::App* check_app = app.add_subcommand(
      "check",
      "Check a scene: what it is, which physics it uses, what it needs, how long it takes");
  add_scene_options(*check_app, check.scene);
  add_spacing_option(*check_app, check.scene);
  check_app->add_flag("--probe", check.probe,
                      "Find out what sets the time step, and how far it is from unstable");
  check_app->add_flag("--costs", check.costs,
                      "Measure what each part of the physics costs, by steps without it");

  ConvergeArguments converge;
  CLI::App* converge_app = app.add_subcommand(
      "converge", "Run a scene at three spacings, estimate the errors and advise a spacing");
  add_scene_options(*converge_app, converge.scene);
  converge_app
      ->add_option(
          "--spacings", converge.spacings,
          "Three spacings, e.g. \"1 m, 0.5 m, 0.25 m\"; default: 4, 2 and 1 times the scene's")
      ->delimiter(',')
      ->expected(3);
  add_folder_options(*converge_app, converge, "_converge");

  FosArguments fos;
  CLI::App* fos_app = add_fos_command(app, fos);

  ElementArguments element;
  CLI::App* element_app = add_element_command(app, element);

  NewArguments fresh;
  CLI::App* new_app = app.add_subcommand("new", "Write a commented scene to begin with");
  new_app->add_option("template", fresh.name, "Which one; without it, list them");
  new_app->add_option("file", fresh.file,
                      "Where to write it, - for standard output; default: <template>.toml");

  std::string key;
  CLI::App* explain_app = app.add_subcommand("explain", "Say what a key of a scene means");
  explain_app->add_option("key", key,
                          "Such as cohesion, material.cohesion or stage; without it, list them");

  ReportArguments report;
  CLI::App* report_app = app.add_subcommand(
      "report", "Draw figures and report.html of a run, or of what fos or converge left");
  report_app->add_option("folder", report.folder, "Output folder of a run")
      ->required()
      ->check(CLI::ExistingDirectory);
  add_quiet_option(*report_app, report.quiet);
  report_app
      ->add_option("--picture", report.picture_megabytes,
                   "Megabytes that the moving picture may take, 0 for none; default 40. Of a run "
                   "that needs more it shows fewer moments, then fewer particles")
      ->check(CLI::Range(0.0, 4000.0));

  WatchArguments watch;
  CLI::App* watch_app = app.add_subcommand(
      "watch", "Follow a run in a browser on this machine while it goes on, until Ctrl-C");
  watch_app->add_option("folder", watch.folder, "Output folder of the run")
      ->required()
      ->check(CLI::ExistingDirectory);
  watch_app->add_option("--port", watch.port, "Listen on this port; default: a free one")
      ->check(CLI::Range(1, 65535));

  refuse_empty_values(app);
  for (scarp::RunOptions* options :
       {&run.scene.options, &resume.options, &check.scene.options, &converge.scene.options,
        &fos.scene.options, &element.scene.options})
    options->stop = stop_requested;

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ok : usage;
  }
  const std::string note = scarp::note_on_offered_threads();
  const bool steps = !*report_app && !*watch_app && !*new_app && !*explain_app;
  if (!note.empty() && steps) fmt::print(stderr, "warning: {}.\n", note);
  if (*run_app) return run_command(run);
  if (*resume_app) return resume_command(resume);
  if (*check_app) return check_command(check);
  if (*converge_app) return converge_command(converge);
  if (*fos_app) return fos_command(fos);
  if (*element_app) return element_command(element);
  if (*new_app) return new_command(fresh);
  if (*explain_app) return explain_command(key);
  if (*watch_app) return watch_command(watch);
  return report_command(report);
}

}  // namespace

int main(int argc, char** argv) {
#ifdef M_MMAP_THRESHOLD
  // Blocks from here on go back to the system when freed: by itself the allocator keeps ever larger
  // ones, up to half of what a run needs.
  constexpr int given_back = 1 << 18;
  mallopt(M_MMAP_THRESHOLD, given_back);
#endif
  return end_with_exit_code("scarp", [&] { return run_program(argc, argv); });
}
