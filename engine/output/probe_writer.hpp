// SPDX-License-Identifier: BSD-3-Clause
/// Histories of a run as CSV tables: step, probes, forces on walls, energies.
#pragma once

#include <filesystem>
#include <optional>

#include "engine/output/text_file.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// Tables that a run goes on with: as its checkpoint knows them, or as they are.
enum class OldTables { as_recorded, as_they_are };

/// Appends one row to each table per call: history.csv always, probes.csv, walls.csv and energy.csv
/// where the scene has probes, walls, `Output::energy`. Column titles end in the unit:
/// "crest.velocity_x [m/s]". In 2D the columns of z, yz and zx are left out and forces and energies
/// are per metre of thickness.
class ProbeWriter {
 public:
  /// Errors: FileError.
  ProbeWriter(const Simulation& simulation, const std::filesystem::path& folder);
  /// Goes on with the tables of a run of which `progress` is a snapshot. Errors: CheckpointError if
  /// rows are missing or changed and `tables` does not accept that.
  ProbeWriter(const Simulation& simulation, const std::filesystem::path& folder,
              const Snapshot& progress, OldTables tables);
  /// Errors: FileError; the rows before stay.
  void write(const Simulation& simulation);
  /// Flushes the tables to the disk and adds their sizes and sums. Errors: FileError.
  void add_progress(Snapshot& snapshot) const;

 private:
  ProbeWriter(const Simulation& simulation, const std::filesystem::path& folder,
              const Snapshot* progress, OldTables tables);

  CsvFile history_;
  std::optional<CsvFile> probes_, walls_, energy_;
};

}  // namespace scarp
