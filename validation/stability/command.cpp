// SPDX-License-Identifier: BSD-3-Clause
/// Cell after cell, with what is left to do.
#include "validation/stability/command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "engine/errors.hpp"
#include "engine/output/results.hpp"
#include "engine/output/text_file.hpp"
#include "engine/plain_text.hpp"
#include "validation/report.hpp"
#include "validation/stability/map_output.hpp"

namespace scarp::validation {
namespace {

std::string read_text(const char* path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool wanted(const Cell& cell, const std::string& axis) {
  return cell.axis.find(axis) != std::string::npos || cell.group.find(axis) != std::string::npos;
}

}  // namespace

int stability_command(const StabilityArguments& arguments) {
  const std::filesystem::path folder = std::filesystem::path(arguments.out) / "stability";
  make_output_folder(folder);
  std::vector<Cell> cells = stability_cells(arguments.short_form);
  std::erase_if(cells, [&](const Cell& cell) { return !wanted(cell, arguments.axis); });
  if (cells.empty()) {
    throw Error(fmt::format("--axis {}: no axis or group has this in its name. Try \"stiffness\".",
                            arguments.axis));
  }
  const Simulation probe(cells.front().scene, arguments.run);
  const Bench bench{program_version(), probe.isa(), processor_name(), probe.threads(),
                    hash_of(read_text("/proc/self/exe"))};
  CellLog log(folder / "runs.jsonl");
  const auto to_run = [&](std::size_t from) {
    return std::count_if(
        cells.begin() + static_cast<std::ptrdiff_t>(from), cells.end(),
        [&](const Cell& cell) { return log.find(cell_key(bench, cell)) == nullptr; });
  };
  double spent = 0.0;  ///< by the cells that were run [s]
  int run = 0;
  std::vector<CellOutcome> outcomes;
  bool pass = true;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Cell& cell = cells[k];
    const std::string key = cell_key(bench, cell);
    const CellRecord* record = log.find(key);
    if (record == nullptr) {
      CellRecord fresh = run_cell(cell, arguments.run);
      fresh.key = key;
      log.append(fresh);
      record = log.find(key);
      spent += record->wall_s;
      ++run;
    }
    if (!arguments.quiet) {
      const double left = run > 0 ? static_cast<double>(to_run(k + 1)) * spent / run : 0.0;
      fmt::print(
          stderr, "{}/{} {}, {} ({}{}): {}, {:.1f} s{}{}\n", k + 1, cells.size(), cell.axis,
          cell.value, cell.scene.numerics.preset,
          cell.scene.numerics.precision == Precision::mixed ? ", mixed" : "", word(record->verdict),
          record->wall_s,
          record->stable_cfl ? fmt::format(", stable to CFL {:.3g} of {:g}", *record->stable_cfl,
                                           cell.scene.numerics.cfl)
                             : std::string(),
          left > 0.0 ? fmt::format("; about {} left", readable_duration(left)) : std::string());
      std::fflush(stderr);
    }
    pass &= record->verdict != Verdict::failed;
    outcomes.push_back({cell, *record});
  }
  const std::string json = write_map(folder, bench, arguments.short_form, outcomes);
  if (arguments.json == "-") {
    fmt::print("{}", json);
  } else {
    if (!arguments.json.empty()) write_to_target(arguments.json, json);
    for (const std::string& line : map_sentences(outcomes)) fmt::print("{}\n", line);
  }
  std::fflush(stdout);
  fmt::print(stderr, "{}\n", write_report(folder, arguments.quiet));
  return pass ? 0 : 1;
}

}  // namespace scarp::validation
