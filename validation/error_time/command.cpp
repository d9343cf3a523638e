// SPDX-License-Identifier: BSD-3-Clause
/// Cases, budget and files of error against run time.

#include "validation/error_time/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <system_error>

#include "engine/errors.hpp"
#include "engine/output/text_file.hpp"
#include "engine/scene/units.hpp"
#include "validation/error_time/output.hpp"
#include "validation/report.hpp"

namespace scarp::validation {
namespace {

/// Cases asked for by their own name must have a scalar error; a set gives those that have one.
std::vector<const CaseRow*> problems(const std::vector<std::string>& names) {
  std::vector<const CaseRow*> rows;
  const std::vector<std::string> asked = names.empty() ? std::vector<std::string>{"all"} : names;
  for (const CaseRow* row : select_cases(asked)) {
    const bool by_name = std::find(asked.begin(), asked.end(), row->name) != asked.end();
    if (row->problem != nullptr || by_name) rows.push_back(row);
  }
  return rows;
}

}  // namespace

int error_time_command(const ErrorTimeArguments& arguments) {
  using Clock = std::chrono::steady_clock;
  StudyOptions options = arguments.options;
  options.axes = parse_axes(arguments.axes);
  options.out = std::filesystem::path(arguments.out) / "error_time";
  if (options.short_form) options.repeats = std::min(options.repeats, 2);
  std::optional<double> budget_s;
  if (!arguments.budget.empty()) {
    budget_s = parse_quantity(arguments.budget, kernels::Unit::time);
  }
  const std::vector<const CaseRow*> rows = problems(arguments.cases);
  for (const CaseRow* row : rows) require_problem(*row);
  make_output_folder(options.out);
  const Clock::time_point start = Clock::now();
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (budget_s) {  // what earlier cases left over goes to the later ones
      const double gone = std::chrono::duration<double>(Clock::now() - start).count();
      options.budget_s = (*budget_s - gone) / static_cast<double>(rows.size() - k);
    }
    const ErrorStudy study = run_study(*rows[k], options);
    write_study(options.out, study);
    if (arguments.json != "-") fmt::print("{}", study_text(study));
    std::fflush(stdout);
  }
  const std::string json = write_overall(options.out);
  if (arguments.json == "-") {
    fmt::print("{}", json);
  } else if (!arguments.json.empty()) {
    write_to_target(arguments.json, json);
  }
  std::fflush(stdout);
  fmt::print(stderr, "{}\n", write_report(options.out, options.quiet));
  return 0;
}

}  // namespace scarp::validation
