// SPDX-License-Identifier: BSD-3-Clause
/// Stress and support of a simulation at its start.
#include "engine/check/start_warnings.hpp"

#include <utility>

#include "engine/check/initial_stress.hpp"
#include "engine/check/thin_walls.hpp"
#include "engine/check/wall_support.hpp"

namespace scarp::check {

std::vector<std::string> start_warnings(const Simulation& simulation) {
  std::vector<std::string> found = initial_stress_warnings(simulation);
  const std::vector<double> position = simulation.field("position");
  std::vector<Vec3> soil(position.size() / 3);
  for (std::size_t k = 0; k < position.size(); ++k) soil[k / 3][k % 3] = position[k];
  for (std::string& place : soil_over_nothing(simulation.scene(), soil))
    found.push_back(std::move(place));
  for (std::string& wall : thin_walls(simulation.scene(), soil)) found.push_back(std::move(wall));
  return found;
}

}  // namespace scarp::check
