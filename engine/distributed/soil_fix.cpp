// SPDX-License-Identifier: GPL-2.0-only
/// What LAMMPS asks about particles when it moves them.
#include "engine/distributed/soil_fix.hpp"

#include <atom.h>

#include <algorithm>
#include <cstdlib>

#include "engine/parallel.hpp"

namespace scarp::distributed {

using LAMMPS_NS::Atom;

SoilFix::SoilFix(LAMMPS_NS::LAMMPS* lammps, int count, char** arguments)
    : Fix(lammps, count, arguments),
      width_(static_cast<std::size_t>(std::strtol(arguments[3], nullptr, 10))) {
  maxexchange = static_cast<int>(width_);
  comm_forward = static_cast<int>(std::strtol(arguments[4], nullptr, 10));
  SoilFix::grow_arrays(atom->nmax);
  atom->add_callback(Atom::GROW);
}

SoilFix::~SoilFix() { atom->delete_callback(id, Atom::GROW); }

void SoilFix::grow_arrays(int size) { place.resize(static_cast<std::size_t>(size)); }

void SoilFix::copy_arrays(int from, int to, int) {
  place[static_cast<std::size_t>(to)] = place[static_cast<std::size_t>(from)];
}

int SoilFix::pack_exchange(int index, double* buffer) {
  const std::int64_t at = place[static_cast<std::size_t>(index)];
  if (at >= 0) {
    for (const double* array : carried) *buffer++ = array[at];
  } else {
    const auto first = came.begin() + (-1 - at) * static_cast<std::int64_t>(width_);
    std::copy(first, first + static_cast<std::int64_t>(width_), buffer);
  }
  return static_cast<int>(width_);
}

int SoilFix::unpack_exchange(int index, double* buffer) {
  place[static_cast<std::size_t>(index)] = -1 - static_cast<std::int64_t>(came.size() / width_);
  came.insert(came.end(), buffer, buffer + width_);
  return static_cast<int>(width_);
}

int SoilFix::pack_forward_comm(int count, int* list, double* buffer, int, int*) {
  const auto width = static_cast<std::int64_t>(refreshed.size());
  const auto pack = [&](std::int64_t begin, std::int64_t end) {
    double* next = buffer + begin * width;
    for (std::int64_t k = begin; k < end; ++k) {
      // Ghosts are passed on: to those beside a neighbour along another axis.
      const bool own = list[k] < atom->nlocal;
      const std::int64_t slot = own ? place[static_cast<std::size_t>(list[k])]
                                    : ghost_place[static_cast<std::size_t>(list[k] - atom->nlocal)];
      for (const Column& column : refreshed) *next++ = (own ? column.soil : column.ghost)[slot];
    }
  };
  parallel_chunks(threads, count, particle_chunk, pack);
  ++messages;
  values += count * width;
  return static_cast<int>(count * width);
}

void SoilFix::unpack_forward_comm(int count, int first, double* buffer) {
  const auto width = static_cast<std::int64_t>(refreshed.size());
  const auto unpack = [&](std::int64_t begin, std::int64_t end) {
    const double* next = buffer + begin * width;
    for (std::int64_t k = begin; k < end; ++k) {
      const std::int64_t slot =
          ghost_place[static_cast<std::size_t>(first - atom->nlocal) + static_cast<std::size_t>(k)];
      for (const Column& column : refreshed) column.ghost[slot] = *next++;
    }
  };
  parallel_chunks(threads, count, particle_chunk, unpack);
}

}  // namespace scarp::distributed
