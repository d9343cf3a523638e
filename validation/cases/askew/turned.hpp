// SPDX-License-Identifier: BSD-3-Clause
/// A scene turned against the lattice, and its measures in axes that turn with it.
#pragma once

#include <vector>

#include "engine/simulation.hpp"

namespace scarp::validation {

/// Bodies, walls, probes and gravity of a plane scene turned by `angle` [rad] about the origin,
/// counter-clockwise. The lattice keeps its axes. Errors: Error for a body that is not a polygon.
Scene turned(Scene scene, double angle);

/// One particle in the axes of the scene before it was turned.
struct TurnedBack {
  Vec3 start{};                         ///< place at the beginning of the run [m]
  Vec3 displacement{};                  ///< since the last reset [m]
  double xx = 0.0, yy = 0.0, xy = 0.0;  ///< stress [Pa]
};

/// All soil of a scene that was turned by `angle` [rad]; `start` is where displacement is counted
/// from.
std::vector<TurnedBack> turned_back(const Simulation& simulation, double angle);

/// A vector in those axes.
Vec3 turned_back(const Vec3& vector, double angle);

}  // namespace scarp::validation
