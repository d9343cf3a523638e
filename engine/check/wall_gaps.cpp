// SPDX-License-Identifier: BSD-3-Clause
/// Edges of facets against all other facets.
#include "engine/check/wall_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fmt/format.h>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/wall_joints.hpp"
#include "engine/boundary/wall_surface.hpp"
#include "engine/particles/shapes.hpp"
#include "engine/scene/smoothing_choice.hpp"

namespace scarp {

using namespace geometry;

namespace {

/// A point of the edge of a facet, and the way out of the facet across that edge.
struct EdgePoint {
  Vec3 place{};
  Vec3 outward{};
};

/// The two ends of a facet in 2D, points every spacing around it in 3D.
std::vector<EdgePoint> edge_points(const Facet& facet, int dimension, double spacing) {
  const auto at = [&facet](double u, double v) {
    return plus(plus(facet.origin, u, facet.tangent_u), v, facet.tangent_v);
  };
  const Vec3 u_out = facet.tangent_u, v_out = facet.tangent_v;
  const Vec3 u_back = minus(Vec3{}, u_out), v_back = minus(Vec3{}, v_out);
  if (dimension == 2) return {{at(0.0, 0.0), u_back}, {at(facet.length_u, 0.0), u_out}};
  std::vector<EdgePoint> points;
  const auto along = [&](double length, auto&& point) {
    const int steps = static_cast<int>(std::clamp(std::ceil(length / spacing), 1.0, 1e5));
    for (int k = 0; k <= steps; ++k) point(length * k / steps);
  };
  along(facet.length_u, [&](double u) {
    points.push_back({at(u, 0.0), v_back});
    points.push_back({at(u, facet.length_v), v_out});
  });
  along(facet.length_v, [&](double v) {
    points.push_back({at(0.0, v), u_back});
    points.push_back({at(facet.length_u, v), u_out});
  });
  return points;
}

}  // namespace

std::vector<std::string> wall_gaps(const Scene& scene) {
  const double touching = 1e-6 * scene.spacing;
  const double reach = 2.0 * smoothing_length_of(scene);
  constexpr double ahead = 0.7;  // within 45 degrees of the way out
  Scene joined = scene;
  close_narrow_gaps(joined);
  const WallSurface surface(joined);
  FacetSearch search;
  std::vector<std::string> found;
  std::uint32_t number = 0;
  for (std::size_t w = 0; w < scene.walls.size(); ++w) {
    const Wall& wall = joined.walls[w];
    for (std::size_t f = 0; f < wall.facets.size(); ++f, ++number) {
      const Facet &facet = wall.facets[f], &drawn = scene.walls[w].facets[f];
      const double longer =
          std::max(facet.length_u - drawn.length_u, facet.length_v - drawn.length_v);
      if (longer > touching) {
        found.push_back(fmt::format(
            "wall '{}' at {} ends less than a spacing short of another one: it is lengthened by "
            "{:.3g} m to meet it.",
            wall.name, point_text(drawn.origin, scene.dimension), longer));
      }
      for (const auto& [point, outward] : edge_points(facet, scene.dimension, scene.spacing)) {
        const WallSurface::Nearest other = surface.nearest(point, reach, number, search);
        if (other.distance <= touching || other.distance > reach) continue;
        if (dot(minus(other.point, point), outward) < ahead * other.distance) continue;
        found.push_back(fmt::format(
            "wall '{}' ends at {}, {:.3g} m from wall '{}': soil can leak through the gap. Try to "
            "let them meet.",
            wall.name, point_text(point, scene.dimension), other.distance,
            scene.walls[surface.wall_of(other.face)].name));
        break;
      }
    }
  }
  return found;
}

}  // namespace scarp
