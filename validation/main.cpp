// SPDX-License-Identifier: BSD-3-Clause
/// The program `scarp-validate`: runs cases, judges them, shows the verdict.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "engine/cli/ending.hpp"
#include "engine/cli/interrupt.hpp"
#include "engine/errors.hpp"
#include "engine/isa_names.hpp"
#include "engine/output/results.hpp"
#include "engine/output/text_file.hpp"
#include "engine/scene/units.hpp"
#include "engine/team.hpp"
#include "validation/case_list.hpp"
#include "validation/error_time/command.hpp"
#include "validation/report.hpp"
#include "validation/stability/command.hpp"

namespace scarp::validation {

namespace {

using cli::failed, cli::ok, cli::usage;

struct Arguments {
  std::vector<std::string> cases;
  CaseOptions options;
  bool short_form = false, full = false, forecast_only = false;
  std::string spacing, json, report_folder;
  ErrorTimeArguments error_time;
  StabilityArguments stability;
};

nlohmann::ordered_json read_json(const std::filesystem::path& path) {
  std::ifstream stream(path);
  return nlohmann::ordered_json::parse(stream);
}

/// Whether the results that an earlier call left stand for this one.
bool is_kept(const CaseRow& row, const CaseOptions& options) {
  const std::filesystem::path path = options.out / row.name / "results.json";
  if (!options.resume || row.keeps_runs || !std::filesystem::exists(path)) return false;
  try {
    const auto json = read_json(path);
    return json.at("complete").get<bool>() && json.at("options") == options_key(options);
  } catch (const nlohmann::json::exception&) {  // cut short, or of an older version
    return false;
  }
}

/// Runs one case to its verdict; whatever goes wrong in it is part of that verdict.
bool run_case(const CaseRow& row, const CaseOptions& options) {
  if (is_kept(row, options)) {
    const bool pass = read_json(options.out / row.name / "results.json")["pass"].get<bool>();
    fmt::print("{} {}: kept\n", pass ? "PASS" : "FAIL", row.name);
    return pass;
  }
  CaseRun run(std::string(row.name), options);
  try {
    row.function(run);
  } catch (const Stopped&) {
    throw;
  } catch (...) {
    run.finish(nullptr, reason_of(std::current_exception()));
  }
  if (options.forecast != nullptr) options.forecast->end(std::string(row.name));
  fmt::print("{}", console_table(run.result()));
  fmt::print("  {}\n", write_report(run.folder(), options.quiet));
  std::fflush(stdout);
  return passed(run.result());
}

/// Times a few steps of every run to come and says what all will take.
void forecast_runs(const std::vector<const CaseRow*>& rows, const CaseOptions& options,
                   SetForecast& forecast) {
  for (const CaseRow* row : rows) {
    if (row->runs == nullptr || is_kept(*row, options)) continue;
    const std::string name(row->name);
    for (const PlannedRun& planned : row->runs(CaseRun(name, options))) {
      forecast.plan(name, planned, options.run);
    }
  }
  forecast.print();
}

/// Draws the page over all cases in the folder, which cases.json names for it.
void write_overview(const std::filesystem::path& folder, bool quiet) {
  nlohmann::ordered_json json{{"format", "scarp cases"}, {"version", 1}};
  json["cases"] = nlohmann::ordered_json::array();
  for (const CaseRow& row : case_list) {
    json["cases"].push_back({{"name", row.name}, {"set", row.set}, {"sentence", row.sentence}});
  }
  replace_file(folder / "cases.json", json.dump(2) + "\n");
  fmt::print(stderr, "all cases: {}\n", write_report(folder, quiet));
}

int run_command(Arguments& arguments) {
  const std::vector<const CaseRow*> rows = select_cases(arguments.cases);
  CaseOptions& options = arguments.options;
  options.form = arguments.short_form ? Form::short_form : arguments.full ? Form::full : Form::main;
  if (!arguments.spacing.empty()) {
    const bool bare = arguments.spacing.find_first_not_of("0123456789.,+-eE") == std::string::npos;
    options.spacing =
        parse_quantity(bare ? arguments.spacing + " m" : arguments.spacing, kernels::Unit::length);
    if (!(options.spacing > 0.0)) throw UnitError("it is not above 0. Try \"0.5 m\".");
  }
  SetForecast forecast(options.quiet);
  forecast_runs(rows, options, forecast);
  if (arguments.forecast_only) return ok;
  options.forecast = &forecast;
  bool all_pass = true;
  nlohmann::ordered_json results{{"format", "scarp validation"}, {"version", 1}};
  results["cases"] = nlohmann::ordered_json::array();
  for (const CaseRow* row : rows) {
    if (rows.size() > 1) {
      const std::size_t number = results["cases"].size() + 1;
      options.whole.part = fmt::format("case {} of {}", number, rows.size());
    }
    all_pass &= run_case(*row, options);
    results["cases"].push_back(read_json(options.out / row->name / "results.json"));
  }
  results["pass"] = all_pass;
  if (rows.size() > 1) write_overview(options.out, options.quiet);
  if (arguments.json == "-") fmt::print("{}\n", results.dump(2));
  if (!arguments.json.empty() && arguments.json != "-") {
    write_to_target(arguments.json, results.dump(2) + "\n");
  }
  return all_pass ? ok : failed;
}

/// Draws again the report of one case, of error against run time, or of everything in a folder.
int report_command(const std::string& folder, bool quiet) {
  std::vector<std::filesystem::path> folders;
  const std::filesystem::path here = folder;
  const bool one = std::filesystem::exists(here / "results.json") ||
                   std::filesystem::exists(here / "error_time.json") ||
                   std::filesystem::exists(here / "stability.json");
  if (one) {
    folders.push_back(here);
  } else {
    for (const CaseRow& row : case_list) {
      const std::filesystem::path inner = here / row.name;
      if (std::filesystem::exists(inner / "results.json")) folders.push_back(inner);
    }
  }
  if (folders.empty()) {
    throw FileError(fmt::format(
        "'{}': no results.json in it or in a case's folder below it. Try the folder that "
        "'scarp-validate run' printed.",
        folder));
  }
  if (!one && std::filesystem::exists(here / "error_time" / "error_time.json")) {
    folders.push_back(here / "error_time");
  }
  if (!one && std::filesystem::exists(here / "stability" / "stability.json")) {
    folders.push_back(here / "stability");
  }
  for (const auto& path : folders) fmt::print("{}\n", write_report(path, quiet));
  if (!one) write_overview(here, quiet);
  return ok;
}

void add_threads(CLI::App& command, std::optional<int>& threads) {
  command
      .add_option("--threads", threads,
                  "Use exactly this many threads; default: as many as make it faster")
      ->check([](const std::string& text) {
        int wanted = 0;
        return CLI::detail::lexical_cast(text, wanted) ? complaint_about_threads(wanted)
                                                       : std::string();
      });
}

void add_error_time(CLI::App& command, ErrorTimeArguments& arguments) {
  command.add_option("cases", arguments.cases,
                     "Names of cases or sets; default: all cases that have a scalar error");
  command
      .add_option("--axis", arguments.axes,
                  "Vary these axes only, with commas or repeated; default: all of " +
                      fmt::format("{}", fmt::join(axis_names(), ", ")))
      ->allow_extra_args(false);
  command.add_flag("--short", arguments.options.short_form,
                   "Take two coarse spacings and few settings");
  command
      .add_option("--repeats", arguments.options.repeats, "Run each setting this often; default 3")
      ->check(CLI::Range(1, 100));
  command.add_option("--budget", arguments.budget,
                     "Begin no run that would end after this time, e.g. \"90 min\"");
  command.add_option("-o,--out", arguments.out,
                     "Folder in which error_time/ is made; default: out");
  add_threads(command, arguments.options.run.threads);
  command
      .add_option("--isa", arguments.options.run.isa,
                  "Use this instruction set; default: the best of the machine")
      ->check(CLI::IsMember(isa_names()));
  command.add_option("--json", arguments.json,
                     "Write the sentences to this file, - for standard output");
  command.add_flag("-q,--quiet", arguments.options.quiet, "Show no progress");
}

void add_stability(CLI::App& command, StabilityArguments& arguments) {
  command.add_option("--axis", arguments.axis, "Run only axes and groups whose name contains this");
  command.add_flag("--short", arguments.short_form,
                   "Run the ends of the axes only, with few steps");
  command.add_option("-o,--out", arguments.out, "Folder in which stability/ is made; default: out");
  add_threads(command, arguments.run.threads);
  command
      .add_option("--isa", arguments.run.isa,
                  "Use this instruction set; default: the best of the machine")
      ->check(CLI::IsMember(isa_names()));
  command.add_option("--json", arguments.json, "Write the map to this file, - for standard output");
  command.add_flag("-q,--quiet", arguments.quiet, "Show no progress");
}

int run_program(int argc, char** argv) {
  CLI::App app{"Runs scarp's validation cases and compares them with what is known"};
  app.set_version_flag("--version", "scarp-validate " + program_version());
  app.require_subcommand(1);
  app.footer(
      "Exit codes: 0 everything judged passes, 1 it does not, 2 bad usage, 130 stopped by a "
      "signal.");
  Arguments arguments;
  CaseOptions& options = arguments.options;
  for (RunOptions* run_options :
       {&options.run, &arguments.error_time.options.run, &arguments.stability.run})
    run_options->stop = cli::stop_requested;

  CLI::App* list = app.add_subcommand("list", "List the cases, one per line");

  CLI::App* run = app.add_subcommand("run", "Run cases, or the sets paper, verification and all");
  run->add_option("cases", arguments.cases, "Names of cases or sets")->required();
  CLI::Option* short_flag = run->add_flag("--short", arguments.short_form,
                                          "Run the short form, which is coarse and quick");
  run->add_flag("--full", arguments.full, "Run the full form, which adds finer spacings")
      ->excludes(short_flag);
  run->add_option("-o,--out", options.out, "Folder in which each case makes its own; default: out");
  add_threads(*run, options.run.threads);
  run->add_option("--preset", options.preset, "Replace the preset of the scenes")
      ->check(CLI::IsMember({"modern", "paper"}));
  run->add_option("--precision", options.precision, "Replace the precision of the pair sweep")
      ->check(CLI::IsMember({"double", "mixed"}));
  run->add_option("--spacing", arguments.spacing, "Replace the particle spacing, e.g. \"0.5 m\"");
  run->add_option("--isa", options.run.isa,
                  "Use this instruction set; default: the best of the machine")
      ->check(CLI::IsMember(isa_names()));
  run->add_flag("--resume", options.resume,
                "Keep the runs that an earlier call with the same options finished, do the others");
  run->add_flag("--forecast", arguments.forecast_only,
                "Say how long the paper's cases will take, and run nothing");
  run->add_option("--json", arguments.json,
                  "Write all results to this file, - for standard output");
  run->add_flag("-q,--quiet", options.quiet, "Show no progress");

  CLI::App* error_time = app.add_subcommand(
      "error-time", "Measure error against run time of many settings, and advise which to take");
  add_error_time(*error_time, arguments.error_time);

  CLI::App* stability = app.add_subcommand(
      "stability",
      "Map extreme scenes: where the time step is stable, and what happens where it is not");
  add_stability(*stability, arguments.stability);

  CLI::App* report = app.add_subcommand(
      "report", "Draw reports again: of a case, of all cases, of error-time or stability");
  report->add_option("folder", arguments.report_folder, "Folder of one case or of several")
      ->required()
      ->check(CLI::ExistingDirectory);
  report->add_flag("-q,--quiet", options.quiet, "Show no progress");

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ok : usage;
  }
  if (*list) {
    for (const CaseRow& row : case_list) fmt::print("{:<12} {}\n", row.name, row.sentence);
    return ok;
  }
  try {
    if (*error_time) return error_time_command(arguments.error_time);
    if (*stability) return stability_command(arguments.stability);
    return *run ? run_command(arguments) : report_command(arguments.report_folder, options.quiet);
  } catch (const Stopped&) {
    fmt::print(stderr, "To go on: the same command{}\n",
               *run ? " with --resume; cases that are finished are kept" : "");
    throw;
  } catch (const UnitError& error) {
    throw cli::UsageError(fmt::format("--spacing or --budget: {}", error.what()));
  }
}

}  // namespace
}  // namespace scarp::validation

int main(int argc, char** argv) {
  return scarp::cli::end_with_exit_code("scarp-validate",
                                        [&] { return scarp::validation::run_program(argc, argv); });
}
