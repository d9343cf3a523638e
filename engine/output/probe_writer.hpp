// SPDX-License-Identifier: BSD-3-Clause
/// Histories of a run as CSV tables: step, probes, forces on walls, energies.
#pragma once

#include <filesystem>
#include <optional>

#include "engine/output/text_file.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// Appends one row to each table per call: history.csv always, probes.csv, walls.csv and energy.csv
/// where the scene has probes, walls, `Output::energy`. Column titles end in the unit:
/// "crest.velocity_x [m/s]". In 2D the columns of z, yz and zx are left out and forces and energies
/// are per metre of thickness.
class ProbeWriter {
 public:
  /// Errors: FileError.
  ProbeWriter(const Simulation& simulation, const std::filesystem::path& folder);
  /// Goes on with the tables of a run of which `progress` is a snapshot. Errors: CheckpointError if
  /// rows are missing.
  ProbeWriter(const Simulation& simulation, const std::filesystem::path& folder,
              const Snapshot& progress);
  /// Errors: FileError; the rows before stay.
  void write(const Simulation& simulation);
  /// Flushes the tables to the disk and adds their sizes. Errors: FileError.
  void add_progress(Snapshot& snapshot) const;

 private:
  ProbeWriter(const Simulation& simulation, const std::filesystem::path& folder,
              const Snapshot* progress);

  CsvFile history_;
  std::optional<CsvFile> probes_, walls_, energy_;
};

}  // namespace scarp
