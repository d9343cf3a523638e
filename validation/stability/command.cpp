// SPDX-License-Identifier: BSD-3-Clause
/// Cell after cell, with what is left to do.
#include "validation/stability/command.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "engine/errors.hpp"
#include "engine/output/results.hpp"
#include "engine/output/text_file.hpp"
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
    }
    if (!arguments.quiet) {
      fmt::print(stderr, "{}/{} {}, {} ({}{}): {}, {:.1f} s{}\n", k + 1, cells.size(), cell.axis,
                 cell.value, cell.scene.numerics.preset,
                 cell.scene.numerics.precision == Precision::mixed ? ", mixed" : "",
                 word(record->verdict), record->wall_s,
                 record->stable_cfl ? fmt::format(", stable to CFL {:.3g} of {:g}",
                                                  *record->stable_cfl, cell.scene.numerics.cfl)
                                    : std::string());
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
  fmt::print(stderr, "{}\n", write_report(folder));
  return pass ? 0 : 1;
}

}  // namespace scarp::validation
