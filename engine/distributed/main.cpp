// SPDX-License-Identifier: GPL-2.0-only
/// The program `scarp-lammps`: scarp's `run` and `resume` by several processes.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/cli/commands.hpp"
#include "engine/cli/interrupt.hpp"
#include "engine/cli/options.hpp"
#include "engine/cli/run_record.hpp"
#include "engine/distributed/follow.hpp"
#include "engine/distributed/processes.hpp"
#include "engine/distributed/soil_parts.hpp"
#include "engine/errors.hpp"
#include "engine/output/results.hpp"
#include "engine/scene/scene_reader.hpp"

namespace {

using namespace scarp;
using namespace scarp::cli;
using namespace scarp::distributed;

/// The headers of LAMMPS are no stable interface: with another release anything could happen.
void require_release() {
  const int here = loaded_lammps_release();
  if (here == lammps_release) return;
  throw Error(fmt::format(
      "this program was built for LAMMPS {}, and the library liblammps that it finds is of {}. Try "
      "the package liblammps0 of Debian 12, or build scarp again.",
      lammps_release, here));
}

Scene scene_to_resume(const ResumeArguments& resume) {
  const RunRecord record = read_record(resume.folder);
  return resume.scene.empty()
             ? read_scene_text(record.scene_text, record.scene_name, record.overrides)
             : read_scene(resume.scene, record.overrides);
}

/// What was asked for.
struct Arguments {
  bool is_run = true;
  RunArguments run;
  ResumeArguments resume;
  bool cut_once = false;

  RunOptions& options() { return is_run ? run.scene.options : resume.options; }
  bool quiet() const { return is_run ? run.quiet : resume.quiet; }
  Scene scene() const { return is_run ? load_scene(run.scene) : scene_to_resume(resume); }
  int command() const { return is_run ? run_command(run) : resume_command(resume); }
};

constexpr std::array not_offered{"check", "converge", "element", "fos", "report"};

/// Returns an exit code where there is nothing to run.
std::optional<int> parse(int argc, char** argv, bool speaks, Arguments& arguments) {
  CLI::App app{"Runs scenes of scarp by several processes: mpirun -np 4 scarp-lammps run SCENE"};
  app.set_version_flag("--version", "scarp-lammps " + program_version());
  app.require_subcommand(1);
  app.footer(exit_codes_text);
  const CLI::App* run = add_run_command(app, arguments.run);
  add_resume_command(app, arguments.resume);
  for (CLI::App* command : app.get_subcommands({}))
    command->add_flag("--cut-once", arguments.cut_once,
                      "Divide the soil among the processes at the start only, not at every "
                      "renewal of the neighbour lists");
  refuse_empty_values(app);
  try {
    if (argc > 1 && std::find(not_offered.begin(), not_offered.end(), std::string_view(argv[1])) !=
                        not_offered.end()) {
      throw CLI::ExtrasError(
          fmt::format("not offered by scarp-lammps: {}. Try scarp {}, which works on one machine.",
                      argv[1], argv[1]),
          CLI::ExitCodes::ExtrasError);
    }
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (!speaks) return error.get_exit_code() == 0 ? ok : usage;
    return app.exit(error) == 0 ? ok : usage;
  }
  arguments.is_run = run->parsed();
  return {};
}

void say_how_shared(const Processes& processes, const SoilParts& parts) {
  const Balance& balance = parts.balance();
  const Traffic& traffic = parts.traffic();
  const Waits& waits = parts.waits();
  fmt::print(
      stderr,
      "{} processes: {} divisions, fullest over mean {:.3f} at first, {:.3f} at last, {:.3f} "
      "at most; {:.6g} ghosts per particle; {} particles moved; {} refreshes in {} messages "
      "with {} numbers\n"
      "first process: {:.3g} s in divisions, {:.3g} s in refreshes, {:.3g} s in joins\n",
      processes.count(), traffic.deals / processes.count(), balance.first, balance.last,
      balance.most, balance.ghosts, traffic.moved, traffic.refreshes / processes.count(),
      traffic.messages, traffic.values, waits.deals, waits.refreshes, waits.joins);
}

/// The first process runs the command, the others what it needs of them.
int run_together(Processes& processes, int argc, char** argv) {
  Arguments arguments;
  if (const auto over = parse(argc, argv, processes.leads(), arguments)) return *over;
  RunOptions& options = arguments.options();
  if (!options.threads) options.threads = 1;
  const auto parts =
      std::make_shared<SoilParts>(processes, !arguments.cut_once, std::max(1, *options.threads));
  options.reduction = parts;
  if (!processes.leads()) {
    catch_interrupts();  // the first process decides whether to stop
    return follow(
        parts, [&] { return arguments.scene(); }, options);
  }
  options.stop = stop_requested;
  const int code = end_with_exit_code("scarp-lammps", [&] {
    require_release();
    return arguments.command();
  });
  if (parts->in_call()) processes.end_all(code);
  parts->finish(code);
  if (processes.count() > 1 && !arguments.quiet() && parts->balance().ghosts > 0.0)
    say_how_shared(processes, *parts);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  Processes processes(argc, argv);
  return run_together(processes, argc, argv);
}
