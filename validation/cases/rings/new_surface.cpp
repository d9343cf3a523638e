// SPDX-License-Identifier: BSD-3-Clause
/// Particles with an empty sector beside them.

#include "validation/cases/rings/new_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <utility>

namespace scarp::validation {
namespace {

/// A particle is at a surface if a sector of 120 degrees has no other within two spacings: on a
/// straight surface 180 degrees are empty, on a lattice inside 45, after any rearrangement
/// hardly 90.
constexpr double reach = 2.0;  // spacings
constexpr double widest = 2.0 * std::numbers::pi / 3.0;

using Cell = std::pair<std::int64_t, std::int64_t>;

/// Pre: `directions` is not empty.
bool has_empty_sector(std::vector<double>& directions) {
  std::sort(directions.begin(), directions.end());
  double gap = directions.front() + 2.0 * std::numbers::pi - directions.back();
  for (std::size_t k = 1; k < directions.size(); ++k)
    gap = std::fmax(gap, directions[k] - directions[k - 1]);
  return gap > widest;
}

std::vector<bool> at_surface(const Simulation& simulation) {
  const std::vector<double> position = simulation.field("position");
  const double length = reach * simulation.scene().spacing;
  const std::size_t count = simulation.soil_count();
  std::vector<bool> found(count);
  for (std::size_t body = 0; body < 2; ++body) {
    const std::size_t begin = body * count / 2, end = (body + 1) * count / 2;
    const auto cell_of = [&](std::size_t i) {
      return Cell{static_cast<std::int64_t>(std::floor(position[3 * i] / length)),
                  static_cast<std::int64_t>(std::floor(position[3 * i + 1] / length))};
    };
    std::map<Cell, std::vector<std::size_t>> cells;
    for (std::size_t i = begin; i < end; ++i) cells[cell_of(i)].push_back(i);
    std::vector<double> directions;
    for (std::size_t i = begin; i < end; ++i) {
      const Cell home = cell_of(i);
      directions.clear();
      for (std::int64_t k = 0; k < 9; ++k) {
        const auto cell = cells.find({home.first + k % 3 - 1, home.second + k / 3 - 1});
        if (cell == cells.end()) continue;
        for (const std::size_t j : cell->second) {
          const double x = position[3 * j] - position[3 * i];
          const double y = position[3 * j + 1] - position[3 * i + 1];
          if (j != i && std::hypot(x, y) <= length) directions.push_back(std::atan2(y, x));
        }
      }
      found[i] = directions.empty() || has_empty_sector(directions);
    }
  }
  return found;
}

}  // namespace

NewSurface::NewSurface(const Simulation& start) : at_start_(at_surface(start)) {}

std::size_t NewSurface::count(const Simulation& now) const {
  const std::vector<bool> at_now = at_surface(now);
  std::size_t count = 0;
  for (std::size_t i = 0; i < at_now.size(); ++i) count += at_now[i] && !at_start_[i];
  return count;
}

}  // namespace scarp::validation
