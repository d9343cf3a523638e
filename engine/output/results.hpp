// SPDX-License-Identifier: BSD-3-Clause
/// results.json: what a run was, what it cost, and what was measured.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/errors.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// One number of a run, with what it is held against if anything is.
struct Measure {
  std::string name;
  double value = 0.0;
  std::string unit;
  std::optional<double> reference;
  std::optional<std::array<double, 2>> band;  ///< accepted values, lowest and highest
  std::string source;                         ///< of the reference
  std::optional<bool> pass;                   ///< empty: reported only
};

struct StageResult {
  std::string name;
  double end_time = 0.0;  ///< [s]
  std::uint64_t end_step = 0;
  bool reached_rest = false;
};

/// The processor's name as Linux gives it, else "unknown".
std::string processor_name();

/// The version of scarp.
std::string program_version();

/// Basic facts of the present state, none of them judged: largest displacement of what is not lost,
/// residual velocity, mass, energies.
std::vector<Measure> basic_measures(const Simulation& simulation);

/// A run that became unstable went back and on with shorter steps.
struct Retry {
  std::uint64_t step = 0;     ///< when it was unstable
  std::uint64_t back_to = 0;  ///< step it went on from
  double step_factor = 1.0;   ///< on the time step from there on
  std::string reason;
};

struct RunResults {
  std::string case_name;
  double wall_seconds = 0.0;
  std::vector<StageResult> stages;
  std::vector<Measure> measures;
  std::string failure;  ///< why the run did not reach its end with all its soil; empty if it did
  std::optional<Instability> instability = {};  ///< ... if it became unstable
  std::vector<Retry> retries = {};
  std::vector<PhaseTime> outputs = {};  ///< wall time of what a run writes
};

/// Writes results.json, version 1 (format documented in `engine/output/FORMATS.md`). "pass" is
/// false if a measure failed or there is a `failure`, else true, or null if nothing was judged.
/// Errors: FileError.
void write_results(const std::filesystem::path& path, const Simulation& simulation,
                   const RunResults& results);

}  // namespace scarp
