// SPDX-License-Identifier: BSD-3-Clause
/// Walls of a run, and the phases that act on them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/boundary/dummies.hpp"
#include "engine/boundary/mirror_images.hpp"
#include "engine/boundary/wall_reaction.hpp"
#include "engine/boundary/wall_surface.hpp"
#include "engine/boundary/walls.hpp"
#include "engine/step/phase.hpp"

namespace scarp {

struct State;

/// One entry for each wall of the scene where nothing else is said.
struct Boundary {
  WallSurface surface;              ///< of every wall, as the scene draws it
  WallDummies dummies;              ///< of every wall, as generated
  std::vector<Vec3> offset;         ///< how far each wall has moved [m]
  std::vector<Vec3> placed_offset;  ///< when `walls` was made [m]
  std::vector<Vec3> built_offset;   ///< when the lists were built [m]
  std::vector<bool> stands;
  std::vector<Vec3> velocity;    ///< now [m/s]
  std::vector<Vec3> hold_force;  ///< of the soil that faces held off in the last step (B4) [N]
  /// Of the soil that there is most of: dummies take its density and stiffness. The momentum
  /// equation sees neither, continuity and viscosity only slightly.
  std::size_t material = 0;
  double moved = 0.0;  ///< farthest since the lists were built [m]
  Walls walls;         ///< dummies of those that stand
  MirrorImages images;
  std::uint64_t holds = 0;  ///< times a grain was held off a face
};

/// Makes the dummies of the walls that stand; the lists are no longer valid.
void place_walls(State& state);
/// Over the time by which the soil drifts too [s].
void move_walls(State& state, double dt);
/// Whether a free-slip wall moves in any stage: its images go twice its way.
bool mirrors_move(const Scene& scene);
/// Records of the dummies, velocity and stress from the soil near them. Equation: B1, B2.
void extrapolate_walls(State& state);
/// Takes from the velocities what would carry grains through a face. Equation: B4.
void hold_off_faces(State& state);
/// How near to a face that rule acts [m].
double hold_off_distance(double spacing);
/// Forces on the walls where everything stands now; sums one force sweep, and one for each wall.
std::vector<WallReaction> wall_reactions(const State& state);

namespace phases {

inline constexpr Phase extrapolate_walls{"extrapolate_walls",
                                         {Part::records, Part::lists, Part::walls},
                                         {Part::records, Part::walls},
                                         scarp::extrapolate_walls};
inline constexpr Phase hold_off_faces{"hold_off_faces",
                                      {Field::position, Field::velocity, Part::lists, Part::walls},
                                      {Field::position, Field::velocity, Part::walls},
                                      scarp::hold_off_faces};

}  // namespace phases

}  // namespace scarp
