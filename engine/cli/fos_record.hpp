// SPDX-License-Identifier: BSD-3-Clause
/// search.json: what a search for a factor of safety has found so far, so that it can go on.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/fos/strength_reduction.hpp"

namespace scarp::cli {

struct SearchRecord {
  std::string key;  ///< all that a trial depends on but its factor, line by line
  bool ended = false;
  double settle_wall_s = 0.0;
  double strengthening = 1.0;    ///< of the present attempt to settle
  std::optional<Trial> elastic;  ///< response of the settled state
  std::vector<Trial> trials;
  std::optional<double> failure_run;  ///< factor of the run that is complete in failure/
};

/// Of a simulation at its start; bounds and tolerance of the search are not in it.
std::string search_key(const Simulation& simulation, const Criterion& criterion);

/// What the folder holds of this search, or an empty record, with page, tables and, if they are of
/// another search, everything else removed. Pre: `claim_folder`. Errors: FileError if another
/// search there has not ended, naming the first difference.
SearchRecord begin_search(const std::filesystem::path& folder, const Scene& scene,
                          const std::string& key);

/// Errors: FileError.
void write_search(const std::filesystem::path& folder, const SearchRecord& record);

/// The state on the way to rest, in place of those before. Errors: FileError.
void keep_state(const std::filesystem::path& folder, const Simulation& simulation);

/// The state kept, or nothing; says on standard error why it cannot be read.
std::optional<Snapshot> kept_settling(const std::filesystem::path& folder);

/// Away with it: the slope is settled once more from the start. Errors: FileError.
void forget_state(const std::filesystem::path& folder);

}  // namespace scarp::cli
