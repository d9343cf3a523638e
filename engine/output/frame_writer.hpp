// SPDX-License-Identifier: BSD-3-Clause
/// Frames for ParaView, PyVista and the report: one VTKHDF file of all soil particles per moment.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/output/file_mark.hpp"
#include "engine/simulation.hpp"

namespace scarp {

/// Writes all soil particles as one static VTKHDF (1,0) UnstructuredGrid with a single poly-vertex
/// cell: what every reader since VTK 9.1 opens. Point data: the fields of `Simulation::fields()` in
/// 4-byte floats, "id" and "material" as integers, each with its unit as an attribute, SI. Field
/// data and root attributes: time, step, stage, `event` (why the frame was written), dimension,
/// spacing. Errors: FileError; no partial file is left.
void write_soil_frame(const std::filesystem::path& path, const Simulation& simulation,
                      std::string_view event);

/// The same form for the walls' dummy particles; positions only. The group `faces` holds the walls
/// themselves. Errors: FileError.
void write_wall_frame(const std::filesystem::path& path, const Simulation& simulation);

/// How large a frame of the soil is now [bytes].
std::size_t soil_frame_bytes(const Simulation& simulation);

/// Numbers the frames of a run in one folder: soil_00000.hdf, ... and soil.hdf.series with their
/// times, replaced after each frame or, of more than some hundred, after each thirtieth part more,
/// so that all lists together cost no more than the frames do; walls.hdf once, or walls_00000.hdf,
/// ... if a wall moves or is removed.
class FrameWriter {
 public:
  /// Makes the folder and removes frames an earlier run left there. Errors: FileError.
  FrameWriter(const Simulation& simulation, std::filesystem::path folder);

  /// Goes on with the frames of a run of which `progress` is a snapshot; later ones are removed.
  /// Those that are missing or are not as they were written are left out from the list of moments,
  /// and `warnings()` names them. Sums are formed of the newest 2 GiB, older ones only measured.
  /// Errors: CheckpointError.
  FrameWriter(const Simulation& simulation, std::filesystem::path folder, const Snapshot& progress);

  /// Errors: FileError; the frames before stay valid.
  void write(const Simulation& simulation, std::string_view event);

  /// Flushes the frames to the disk and adds their times, sizes and sums. Errors: FileError.
  void add_progress(Snapshot& snapshot);

  /// Replaces the lists if they do not name every frame yet. Errors: FileError.
  void write_lists();

  std::size_t count() const { return frames_.size(); }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct Frame {
    std::size_t number = 0;  ///< in its file names
    double time = 0.0;       ///< [s]
    FileMark soil, walls;    ///< known once flushed
  };
  static std::vector<Frame> frames_from(const Snapshot& progress);
  std::string damage_of(const Frame& frame, bool sizes_only) const;
  void restore_walls(const Simulation& simulation, const Snapshot& progress);
  std::filesystem::path file_of(const char* name, std::size_t number) const;
  void write_series(std::string_view name) const;

  std::filesystem::path folder_;
  std::vector<Frame> frames_;
  std::size_t next_ = 0;                  ///< number of the next frame
  std::size_t flushed_ = 0;               ///< frames known to be on the disk
  std::size_t listed_ = ~std::size_t{0};  ///< frames that the lists name; at first unknown
  FileMark fixed_walls_;                  ///< of walls.hdf, known once a frame was flushed
  bool has_fixed_walls_ = false, has_changing_walls_ = false;
  std::vector<std::string> warnings_;
};

}  // namespace scarp
