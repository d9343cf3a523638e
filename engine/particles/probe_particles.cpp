// SPDX-License-Identifier: BSD-3-Clause
/// The nearest particle, with ties broken by rules.
#include "engine/particles/probe_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/errors.hpp"
#include "engine/particles/shapes.hpp"

namespace scarp {
namespace {

double distance_between(const Vec3& a, const Vec3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Vec3 centre_of(const std::vector<Vec3>& points) {
  Vec3 centre{};
  for (const Vec3& point : points) {
    for (std::size_t a = 0; a < 3; ++a) centre[a] += point[a];
  }
  for (double& x : centre) x /= static_cast<double>(points.size());
  return centre;
}

/// Keeps the candidates whose value is the least, to a tolerance.
template <class Value>
void keep_least(std::vector<std::size_t>& candidates, double tolerance, const Value& value) {
  if (candidates.size() < 2) return;
  std::vector<double> values;
  for (const std::size_t id : candidates) values.push_back(value(id));
  const double least = *std::min_element(values.begin(), values.end());
  std::size_t kept = 0;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    if (values[k] <= least + tolerance) candidates[kept++] = candidates[k];
  }
  candidates.resize(kept);
}

}  // namespace

ChosenParticle particle_of_probe(const Scene& scene, const Particles& soil, const Probe& probe) {
  const double same = 1e-6 * scene.spacing;  // far above round-off, far below what can be seen
  constexpr double furthest = 2.0;           // spacings
  double least = std::numeric_limits<double>::infinity();
  std::size_t nearest = 0;
  for (std::size_t id = 0; id < soil.position.size(); ++id) {
    const double distance = distance_between(soil.position[id], probe.at);
    if (distance < least) {
      least = distance;
      nearest = id;
    }
  }
  if (least > furthest * scene.spacing + same) {
    throw SceneError(fmt::format(
        "{}'{}' at {}: the nearest soil, at {}, is {:.3g} m away, more than two spacings of {:g} "
        "m: "
        "it would follow soil that lies elsewhere. Try a point in the soil or on its surface.",
        message_start(scene, probe), probe.name, point_text(probe.at, scene.dimension),
        point_text(soil.position[nearest], scene.dimension), least, scene.spacing));
  }
  std::vector<std::size_t> candidates;
  for (std::size_t id = 0; id < soil.position.size(); ++id) {
    if (distance_between(soil.position[id], probe.at) <= least + same) candidates.push_back(id);
  }
  ChosenParticle chosen;
  chosen.tied = candidates.size();
  const Vec3& g = scene.gravity;
  const double weight = std::hypot(g[0], g[1], g[2]);
  keep_least(candidates, same, [&](std::size_t id) {
    double depth = 0.0;
    for (std::size_t a = 0; a < 3 && weight > 0.0; ++a)
      depth += soil.position[id][a] * g[a] / weight;
    return depth;
  });
  keep_least(candidates, 0.0, [&](std::size_t id) {
    const double around = 2.1 * scene.spacing;  // no two points of a lattice are this far apart
    return -static_cast<double>(std::count_if(
        soil.position.begin(), soil.position.end(),
        [&](const Vec3& other) { return distance_between(other, soil.position[id]) < around; }));
  });
  if (candidates.size() > 1) {
    const Vec3 centre = centre_of(soil.position);
    keep_least(candidates, same,
               [&](std::size_t id) { return distance_between(soil.position[id], centre); });
  }
  for (std::size_t a = 0; a < 3; ++a)
    keep_least(candidates, same, [&](std::size_t id) { return soil.position[id][a]; });
  chosen.id = candidates.front();
  chosen.distance = distance_between(soil.position[chosen.id], probe.at);
  return chosen;
}

}  // namespace scarp
