// SPDX-License-Identifier: BSD-3-Clause
/// Crossings of faces from the soil side to the back.
#include "validation/stability/wall_passages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/held_zone.hpp"

namespace scarp::validation {
namespace {

/// Of all grains, those that are lost as well [m/s].
double fastest(const Simulation& simulation) {
  if (simulation.lost_soil().particles == 0) return simulation.last_step().max_velocity;
  const std::vector<double> v = simulation.field("velocity");
  double most = 0.0;
  for (std::size_t k = 0; k < v.size(); k += 3)
    most = std::max(most, std::hypot(v[k], v[k + 1], v[k + 2]));
  return most;
}

}  // namespace

WallPassages::WallPassages(const Scene& scene, std::span<const double> position)
    : dimension_(scene.dimension),
      depth_(held_zone::behind_face * scene.spacing),
      last_(position.begin(), position.end()) {
  for (const Wall& wall : scene.walls) {
    std::size_t removed_at = std::numeric_limits<std::size_t>::max();
    for (std::size_t s = 0; s < scene.stages.size(); ++s)
      if (scene.stages[s].name == wall.removed_at) removed_at = s;
    for (const Facet& facet : wall.facets) faces_.push_back({facet, removed_at});
  }
  behind_.resize(faces_.size() * (position.size() / 3));
  passed_.resize(position.size() / 3);
}

void WallPassages::follow(std::span<const double> position, std::size_t stage) {
  const std::size_t grains = passed_.size();
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const Facet& facet = faces_[f].facet;
    const bool stands = stage < faces_[f].removed_at;
    for (std::size_t k = 0; k < grains; ++k) {
      const Vec3 before{last_[3 * k], last_[3 * k + 1], last_[3 * k + 2]};
      const Vec3 now{position[3 * k], position[3 * k + 1], position[3 * k + 2]};
      const double depth = geometry::coordinates(facet, dimension_, now).depth;
      const bool behind =
          stands && depth > 0.0 &&
          (behind_[f * grains + k] || geometry::goes_in(facet, dimension_, before, now, 0.0));
      behind_[f * grains + k] = behind;
      if (behind && depth > depth_) passed_[k] = true;
    }
  }
  last_.assign(position.begin(), position.end());
}

double WallPassages::passed() const {
  return static_cast<double>(std::count(passed_.begin(), passed_.end(), true));
}

PassageWatch::PassageWatch(const Simulation& start)
    : passages_(start.scene(), start.field("position")), reach_(0.25 * start.scene().spacing) {}

void PassageWatch::after_step(const Simulation& simulation) {
  way_ += fastest(simulation) * simulation.last_step().time_step;
  if (way_ >= reach_) passed(simulation);
}

double PassageWatch::passed(const Simulation& simulation) {
  passages_.follow(simulation.field("position"), simulation.stage_index());
  way_ = 0.0;
  return passages_.passed();
}

}  // namespace scarp::validation
