// SPDX-License-Identifier: GPL-2.0-only
/// The division of the soil among processes, by LAMMPS.
#pragma once

#include <mpi.h>

#include <array>
#include <cstdint>
#include <memory>

#include "engine/particles/particle_buffers.hpp"
#include "engine/step/phase.hpp"

namespace scarp::distributed {

/// The release of LAMMPS that this is written for; its headers are no stable interface.
inline constexpr int lammps_release = 20210929;
/// Of the library that is loaded.
int loaded_lammps_release();

/// What LAMMPS tells particles apart by, and counts them with.
inline constexpr std::int64_t most_particles = 0x7ffffffe;

/// What one process has exchanged with others so far.
struct Traffic {
  std::int64_t deals = 0;      ///< new divisions of the soil
  std::int64_t moved = 0;      ///< particles that came from other processes
  std::int64_t refreshes = 0;  ///< exchanges of values of ghosts
  std::int64_t messages = 0;   ///< that those took
  std::int64_t values = 0;     ///< numbers of 8 bytes that were in them
};

/// Owns a LAMMPS that knows a point for each particle: it cuts the box by recursive coordinate
/// bisection into parts of as many particles, moves particles to the process in whose part they are
/// and says which are ghosts elsewhere. All members are called by all processes together. LAMMPS
/// ends the process on errors of its own: callers check positions and counts first.
class Decomposition {
 public:
  /// `soil` is all there is, the same in each process. `halo`: how far from a part ghosts lie [m].
  /// `rebalance`: cut the box anew at each deal. Pre: at least as many particles as processes, ids
  /// up to `most_particles`. `threads`: of each process, for the values of ghosts.
  Decomposition(MPI_Comm processes, const ParticleBuffers& soil, double halo, bool rebalance,
                int threads);
  ~Decomposition();
  Decomposition(const Decomposition&) = delete;
  Decomposition& operator=(const Decomposition&) = delete;

  /// Leaves of all soil this process's.
  void divide(ParticleBuffers& soil);
  /// See `Reduction`. The order of the particles that stay is kept; those that come follow behind
  /// in the order of their ids. Ghosts are in the order of their ids. Where things go depends on
  /// nothing but where all particles are (if it may `rebalance`).
  void deal(ParticleBuffers& soil, ParticleBuffers& ghosts);
  void refresh(const ParticleBuffers& soil, ParticleBuffers& ghosts, const DataSet& fields);

  const Traffic& traffic() const { return traffic_; }

 private:
  struct Box;
  std::unique_ptr<Box> box_;
  Traffic traffic_;
  bool rebalance_;
};

}  // namespace scarp::distributed
