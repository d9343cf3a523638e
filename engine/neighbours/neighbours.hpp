// SPDX-License-Identifier: BSD-3-Clause
/// Cells and lists of a run, and the phases that keep them.
#pragma once

#include <cstdint>

#include "engine/cells/cell_grid.hpp"
#include "engine/neighbours/fast_grains.hpp"
#include "engine/neighbours/neighbour_lists.hpp"
#include "engine/step/phase.hpp"

namespace scarp {

struct Scene;
struct State;

struct Neighbours {
  ByRole<CellGrid> cells;
  NeighbourLists lists, wall_lists;
  FastGrains fast;             ///< to which the lists reach further
  bool valid = false;          ///< the lists are of the soil and the walls that stand
  bool due = false;            ///< ... and have to be built anew in this step
  double moved = 0.0;          ///< farthest that soil has moved since they were built [m]
  std::uint64_t rebuilds = 0;  ///< of the lists so far
};

/// Records of the soil, and how far it has moved since the lists were built.
void pack_soil(State& state);
/// The same for a sweep of forces, which where forces are corrected takes T = sigma B for the
/// stress. Equation: K3.
void pack_forces(State& state);
/// Whether two particles, or one and a wall, may have come into reach that no list names.
bool lists_are_outdated(const State& state);
void decide_rebuild(State& state);
/// Where that is decided: looks whether walls hold, puts particles in order, builds cells, images
/// and lists, packs the records of the soil again. Errors: SimulationInstability.
void rebuild_lists(State& state);
/// Records of the ghosts, and of the mirror images from those of the soil.
void pack_images(State& state);

/// Cells, images and lists of where everything stands now; `rebuild_lists` also takes that for the
/// place that soil moves from.
void build_lists(State& state);
/// Soil goes to the parts into which it has come.
void deal_soil(State& state);
/// Where the records and lists know of so many slots of soil as there are. Those of dummies are
/// lost.
void fit_records(State& state);
/// How far from a particle lies what its sums may depend on, when lists are built [m].
double halo_of(const Scene& scene);

namespace phases {

inline constexpr DataSet packed_fields{Field::position, Field::velocity, Field::density,
                                       Field::stress, Field::diffusivity};
inline constexpr Phase pack_soil{"pack_soil", packed_fields | DataSet(Field::build_position),
                                 Part::records, scarp::pack_soil};
inline constexpr Phase pack_forces{
    "pack_forces",
    packed_fields | DataSet(Field::build_position, Field::force_moment, Field::strain_rate),
    Part::records, scarp::pack_forces};
inline constexpr Phase decide_rebuild{"decide_rebuild", {}, {}, scarp::decide_rebuild};
inline constexpr Phase rebuild_lists{
    "rebuild_lists", state_fields | DataSet(Part::walls),
    state_fields | DataSet(Part::records, Part::lists, Part::walls), scarp::rebuild_lists};
inline constexpr Phase pack_images{
    "pack_images",
    packed_fields | DataSet(Field::force_moment, Field::strain_rate, Part::records, Part::walls),
    Part::records, scarp::pack_images};

}  // namespace phases

}  // namespace scarp
