// SPDX-License-Identifier: BSD-3-Clause
/// Faces behind faces.
#include "engine/check/thin_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/near_test.hpp"
#include "engine/boundary/wall_surface.hpp"
#include "engine/particles/shapes.hpp"
#include "engine/scene/smoothing_choice.hpp"

namespace scarp {

using namespace geometry;

namespace {

constexpr double back_to_back = -0.9;  ///< largest cosine between the normals

struct Narrowest {
  double thickness = std::numeric_limits<double>::infinity(), needed = 0.0;
  Vec3 place{};
};

class ThinWalls {
 public:
  ThinWalls(const Scene& scene, const std::vector<Vec3>& soil)
      : scene_(scene), soil_(soil), surface_(scene) {}

  std::map<std::pair<std::size_t, std::size_t>, Narrowest> find() {
    for (const Vec3& point : soil_) {
      const auto near = surface_.near(point, scene_.spacing, search_);
      const std::vector<std::uint32_t> faces(near.begin(), near.end());
      for (const std::uint32_t face : faces) look_behind(face, point);
    }
    return std::move(found_);
  }

 private:
  bool is_smooth(std::uint32_t face) const {
    return scene_.walls[surface_.wall_of(face)].kind == WallKind::free_slip;
  }

  /// The soil is put in order only for a scene that has faces back to back.
  bool has_soil_near(const Vec3& point) {
    if (!near_soil_) {
      near_soil_.emplace(scene_.spacing);
      for (std::size_t k = 0; k < soil_.size(); ++k) near_soil_->put(soil_[k], k);
    }
    return near_soil_->has_near(point, soil_);
  }

  /// From the foot of soil before a face to the faces behind it.
  void look_behind(std::uint32_t face, const Vec3& point) {
    const Facet& facet = surface_.facet(face);
    const FacetCoordinates at = coordinates(facet, scene_.dimension, point);
    if (at.depth > 0.0 || at.depth <= -scene_.spacing || !at.above(facet, 0.0)) return;
    const double support = 2.0 * smoothing_length_of(scene_);
    const Vec3 foot = plus(point, at.depth, facet.normal),
               end = plus(foot, -2.0 * support, facet.normal);
    for (const std::uint32_t other : surface_.near(foot, 2.0 * support, search_)) {
      const Facet& back = surface_.facet(other);
      if (other == face || dot(back.normal, facet.normal) > back_to_back) continue;
      if (!comes_out(back, scene_.dimension, foot, end, 0.0)) continue;
      const double thickness = coordinates(back, scene_.dimension, foot).depth;
      const double needed = is_smooth(face) || is_smooth(other) ? 2.0 * support : support;
      if (thickness > needed * (1.0 - 1e-6)) continue;
      const Vec3 beyond = plus(foot, thickness + 0.5 * scene_.spacing, back.normal);
      if (!has_soil_near(beyond)) continue;
      Narrowest& pair = found_[std::minmax({surface_.wall_of(face), surface_.wall_of(other)})];
      if (thickness < pair.thickness) pair = {thickness, needed, foot};
    }
  }

  const Scene& scene_;
  const std::vector<Vec3>& soil_;
  WallSurface surface_;
  std::optional<NearTest> near_soil_;
  FacetSearch search_;
  std::map<std::pair<std::size_t, std::size_t>, Narrowest> found_;  ///< by walls
};

/// Whether some square of a spacing of one facet lies over the other one.
bool overlap(const Facet& one, const Facet& other, int dimension, double spacing) {
  const auto pieces = [&](double length) {
    return static_cast<int>(std::clamp(std::ceil(length / spacing), 1.0, 100.0));
  };
  const int across = dimension == 3 ? pieces(one.length_v) : 1, along = pieces(one.length_u);
  for (int i = 0; i < along; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = (i + 0.5) / along * one.length_u, v = (j + 0.5) / across * one.length_v;
      const Vec3 point = plus(plus(one.origin, u, one.tangent_u), v, one.tangent_v);
      if (coordinates(other, dimension, point).above(other, 0.0)) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<std::string> thin_walls(const Scene& scene, const std::vector<Vec3>& soil) {
  std::vector<std::string> found;
  for (const auto& [walls, pair] : ThinWalls(scene, soil).find()) {
    const std::string &first = scene.walls[walls.first].name,
                      &second = scene.walls[walls.second].name;
    found.push_back(fmt::format(
        "{} {:.3g} m apart at {} with soil on both sides, which act on each other through a wall "
        "thinner than {:.3g} m ({}). Try a slot that wide, or a spacing of {:.2g} m.",
        walls.first == walls.second
            ? fmt::format("wall '{}' has faces back to back", first)
            : fmt::format("walls '{}' and '{}' stand back to back", first, second),
        pair.thickness, point_text(pair.place, scene.dimension), pair.needed,
        pair.needed > 3.0 * smoothing_length_of(scene) ? "4h, as one face is smooth" : "2h",
        scene.spacing * pair.thickness / pair.needed));
  }
  return found;
}

std::vector<std::string> doubled_walls(const Scene& scene) {
  const double tolerance = 1e-3 * scene.spacing;
  const WallSurface surface(scene);
  FacetSearch search;
  std::map<std::pair<std::size_t, std::size_t>, Vec3> found;
  for (std::uint32_t k = 0; k < surface.faces().size(); ++k) {
    const Facet& facet = surface.facet(k);
    for (const std::uint32_t other : surface.near(facet, tolerance, search)) {
      const Facet& second = surface.facet(other);
      const std::pair<std::size_t, std::size_t> walls =
          std::minmax({surface.wall_of(k), surface.wall_of(other)});
      const bool smooth = scene.walls[walls.first].kind == WallKind::free_slip ||
                          scene.walls[walls.second].kind == WallKind::free_slip;
      if (other == k || !smooth || dot(facet.normal, second.normal) < 1.0 - 1e-6) continue;
      const double apart = dot(minus(second.origin, facet.origin), facet.normal);
      if (std::abs(apart) > tolerance) continue;
      if (overlap(facet, second, scene.dimension, scene.spacing))
        found.emplace(walls, facet.origin);
    }
  }
  std::vector<std::string> sentences;
  for (const auto& [walls, place] : found) {
    const std::string &first = scene.walls[walls.first].name,
                      &second = scene.walls[walls.second].name;
    sentences.push_back(fmt::format(
        "{} in one place (near {}), where {}. Try to leave one out; a box leaves out faces by "
        "open.",
        walls.first == walls.second ? fmt::format("wall '{}' has two faces", first)
                                    : fmt::format("walls '{}' and '{}' have faces", first, second),
        point_text(place, scene.dimension),
        scene.walls[walls.first].kind == scene.walls[walls.second].kind
            ? "they act as one"
            : "the rough one alone acts"));
  }
  return sentences;
}

}  // namespace scarp
