// SPDX-License-Identifier: BSD-3-Clause
/// Finds soil that starts inside a wall.
#include "engine/boundary/wall_clearance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "engine/boundary/dummies.hpp"
#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/wall_surface.hpp"
#include "engine/errors.hpp"
#include "engine/particles/shapes.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "engine/stop.hpp"

namespace scarp {

using namespace geometry;

namespace {

/// Whether soil lies in front of the facet too, as near to it as what is seen through a wall.
bool soil_in_front(const Facet& facet, int dimension, const Particles& soil, double thickness) {
  return std::any_of(soil.position.begin(), soil.position.end(), [&](const Vec3& point) {
    const FacetCoordinates at = coordinates(facet, dimension, point);
    return at.depth < 0.0 && at.depth > -thickness && at.above(facet, 0.0);
  });
}

/// Of a sheet pile whose rough faces do not feel each other's soil [m].
double slot_width(const Scene& scene) {
  return std::ceil(2.0 * smoothing_ratio_of(scene) - 1e-9) * scene.spacing;
}

std::string advice(const Scene& scene, const Facet& facet, const Particles& soil,
                   double thickness) {
  if (!soil_in_front(facet, scene.dimension, soil, thickness)) {
    return "Try to reverse the order of the line's points (in 3D: the normal), or move the body or "
           "the wall.";
  }
  return fmt::format(
      "There is soil in front of it as well, but a wall has soil on one side only. Try to draw a "
      "sheet pile as a slot of {:g} m or more that the bodies leave free, with a line up its one "
      "face, over its head and down the other.",
      slot_width(scene));
}

/// Whether the wall behind the face is so thin at this soil that the first layer of dummies, half a
/// spacing behind the face, would stand beyond it.
bool is_void(const Scene& scene, const WallSurface& surface, std::uint32_t face, const Vec3& point,
             std::span<const std::uint32_t> near) {
  const Facet& facet = surface.facet(face);
  const Vec3 foot = plus(point, coordinates(facet, scene.dimension, point).depth, facet.normal);
  const Vec3 dummy = plus(foot, -0.5 * scene.spacing, facet.normal);
  return std::any_of(near.begin(), near.end(), [&](std::uint32_t other) {
    return other != face &&
           comes_out(surface.facet(other), scene.dimension, foot, dummy, 1e-6 * scene.spacing);
  });
}

/// A rough face without any dummies holds nothing. One shorter than four spacings may be the end of
/// a wall that tapers; it counts if its wall has dummies behind no other face either.
void check_wall_thickness(const Scene& scene, const WallSurface& surface, const Particles& soil,
                          const std::function<bool()>& stop) {
  enum : char { untouched, empty, filled };
  std::vector<char> faces(surface.faces().size(), untouched);
  std::vector<Vec3> place(faces.size());
  FacetSearch search;
  for (const Vec3& point : soil.position) {
    stop_if_asked(stop);
    const auto near = surface.near(point, 2.0 * scene.spacing, search);
    for (const std::uint32_t face : near) {
      const auto& [facet, wall] = surface.faces()[face];
      if (faces[face] == filled || scene.walls[wall].kind != WallKind::no_slip) continue;
      const FacetCoordinates at = coordinates(facet, scene.dimension, point);
      if (at.depth > 0.0 || at.depth < -scene.spacing || !at.above(facet, 0.0)) continue;
      faces[face] = is_void(scene, surface, face, point, near) ? empty : filled;
      place[face] = point;
    }
  }
  std::vector<bool> holds(scene.walls.size(), false);
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (faces[k] == filled) holds[surface.faces()[k].wall] = true;
  }
  std::size_t face = 0;
  const auto is_named = [&](std::size_t k) {
    const auto& [facet, wall] = surface.faces()[k];
    const bool is_long = std::max(facet.length_u, facet.length_v) >= 4.0 * scene.spacing;
    return faces[k] == empty && (is_long || !holds[wall]);
  };
  while (face < faces.size() && !is_named(face)) ++face;
  if (face == faces.size()) return;
  const Wall& wall = scene.walls[surface.faces()[face].wall];
  throw SceneError(fmt::format(
      "{}'{}': behind its face before the soil at {} the wall is thinner than half a spacing, so "
      "that no dummy particle fits in, and it would hold nothing. Try a slot of {:g} m or more "
      "that the bodies leave free, or a smaller spacing.",
      message_start(scene, wall), wall.name, point_text(place[face], scene.dimension),
      slot_width(scene)));
}

}  // namespace

void check_wall_clearance(const Scene& scene, const Particles& soil,
                          const std::function<bool()>& stop) {
  const double tolerance = 1e-6 * scene.spacing;
  const double thickness = wall_layers(scene) * scene.spacing;
  const WallSurface surface(scene);
  FacetSearch search;
  std::size_t first = surface.faces().size();
  Vec3 inside{};
  for (const Vec3& point : soil.position) {
    stop_if_asked(stop);
    const auto near = surface.near(point, thickness, search);
    const auto is_inside = [&](std::uint32_t k) {
      const Facet& facet = surface.facet(k);
      const FacetCoordinates at = coordinates(facet, scene.dimension, point);
      if (at.depth <= tolerance || at.depth > thickness || !at.above(facet, 0.0)) return false;
      const Vec3 foot = plus(point, at.depth, facet.normal);
      return std::none_of(near.begin(), near.end(), [&](std::uint32_t other) {
        return other != k &&
               comes_out(surface.facet(other), scene.dimension, foot, point, tolerance);
      });
    };
    const auto found = std::find_if(near.begin(), near.end(), is_inside);
    if (found == near.end() || *found >= first) continue;
    first = *found;
    inside = point;
  }
  if (first == surface.faces().size()) {
    check_wall_thickness(scene, surface, soil, stop);
    return;
  }
  const auto& [facet, number] = surface.faces()[first];
  const Wall& wall = scene.walls[number];
  throw SceneError(fmt::format(
      "{}'{}': the soil particle at {} lies {:.3g} m behind it. {}", message_start(scene, wall),
      wall.name, point_text(inside, scene.dimension),
      coordinates(facet, scene.dimension, inside).depth, advice(scene, facet, soil, thickness)));
}

}  // namespace scarp
