// SPDX-License-Identifier: GPL-2.0-only
/// What LAMMPS asks about particles when it moves them: a fix without physics.
#pragma once

#include <fix.h>

#include <cstdint>
#include <vector>

namespace scarp::distributed {

/// Where values of soil and ghosts stand, component by component.
struct Column {
  const double* soil = nullptr;
  double* ghost = nullptr;
};

/// LAMMPS numbers the particles of a process by a local index, which changes as they come and go;
/// `place` follows it. Values go from scarp's arrays into LAMMPS's messages and back, and stand
/// nowhere else.
class SoilFix : public LAMMPS_NS::Fix {
 public:
  /// Arguments of the LAMMPS command: ID, group, style, values for each particle that moves, and
  /// the most for each ghost.
  SoilFix(LAMMPS_NS::LAMMPS* lammps, int count, char** arguments);
  ~SoilFix() override;

  /// By local index: slot of the soil, or -1 - k for the k-th that came.
  std::vector<std::int64_t> place;
  std::vector<double> came;               ///< their values, particle after particle
  std::vector<const double*> carried;     ///< arrays of the soil that a particle takes along
  std::vector<Column> refreshed;          ///< what the ghosts get now
  std::vector<std::int64_t> ghost_place;  ///< slot of each ghost, from the first local index on
  int threads = 1;                        ///< that copy values of ghosts
  std::int64_t messages = 0, values = 0;  ///< to ghosts elsewhere, so far

  int setmask() override { return 0; }
  void grow_arrays(int size) override;
  void copy_arrays(int from, int to, int) override;
  int pack_exchange(int index, double* buffer) override;
  int unpack_exchange(int index, double* buffer) override;
  int pack_forward_comm(int count, int* list, double* buffer, int, int*) override;
  void unpack_forward_comm(int count, int first, double* buffer) override;

 private:
  std::size_t width_;  ///< values of a particle that moves
};

}  // namespace scarp::distributed
