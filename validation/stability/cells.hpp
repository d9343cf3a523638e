// SPDX-License-Identifier: BSD-3-Clause
/// The cells of the stability map: one factor at a time, pushed to its extremes.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/scene/scene.hpp"

namespace scarp::validation {

struct Cell {
  std::string group;           ///< "stiffness", "strength", "loading", ...: of the map's parts
  std::string axis;            ///< "E", "cohesion", ...
  std::string value;           ///< "100 kPa"
  Scene scene;                 ///< with its preset and precision
  bool bisect = false;         ///< find the largest stable CFL number
  std::uint64_t steps = 2000;  ///< of the last stage, at most
  double displaced = 0.0;      ///< coordinates of particles at the start by up to so many spacings
  bool coincident = false;     ///< the second particle is put on the first
  bool stands = false;         ///< nothing should move without damping
};

/// All cells, those of one axis and value together; the short form has the ends of each axis.
std::vector<Cell> stability_cells(bool short_form);

}  // namespace scarp::validation
