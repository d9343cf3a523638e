// SPDX-License-Identifier: BSD-3-Clause
/// Finds the faces that the lattice does not meet, the soil near them and its neighbourhood.
#include "engine/boundary/packing_zone.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/particles/lattice_places.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "engine/stop.hpp"

namespace scarp {
namespace {

using namespace geometry;

/// A first layer off by this share of a spacing leaves 3e-4 where 1e-3 is asked for: 0.3 off leaves
/// 0.09 (test `MendsAWallBetweenTwoRows`).
constexpr double met = 1e-3;

class Zone {
 public:
  Zone(const Scene& scene, const WallSurface& surface, const std::vector<Vec3>& soil, double reach,
       const std::function<bool()>& stop)
      : scene_(scene), surface_(surface), soil_(soil), reach_(reach), stop_(stop) {}

  PackingZone find() {
    PackingZone zone;
    if (!any_askew()) return zone;
    for (std::size_t k = 0; k < soil_.size(); ++k) {
      stop_if_asked(stop_);
      if (is_near_askew(soil_[k])) zone.soil.push_back(k);
    }
    add_neighbourhood(zone);
    return zone;
  }

 private:
  bool any_askew() {
    askew_.assign(surface_.faces().size(), false);
    const double dx = scene_.spacing;
    for (const Vec3& point : soil_) {
      stop_if_asked(stop_);
      for (const std::uint32_t face : surface_.near(point, dx, search_)) {
        const FacetCoordinates at = coordinates(surface_.facet(face), scene_.dimension, point);
        if (at.depth > dx * met || at.depth < -dx * (1.0 - met)) continue;
        if (!at.above(surface_.facet(face), 0.0)) continue;
        if (std::abs(at.depth / dx + 0.5) > met) askew_[face] = true;
      }
    }
    return std::find(askew_.begin(), askew_.end(), true) != askew_.end();
  }

  bool is_near_askew(const Vec3& point) {
    const auto near = surface_.near(point, reach_, search_);
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t face) {
      const Facet& facet = surface_.facet(face);
      return askew_[face] && coordinates(facet, scene_.dimension, point).distance(facet) < reach_;
    });
  }

  /// Soil may lie on a face, a rounding behind it, and a way may lead through an edge.
  bool wall_between(const Vec3& from, const Vec3& to) {
    const Vec3 way = minus(to, from);
    const auto near = surface_.near(from, std::sqrt(dot(way, way)), search_);
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t face) {
      return goes_in(surface_.facet(face), scene_.dimension, from, to, 0.0, 1e-6 * scene_.spacing);
    });
  }

  /// A body need not be drawn quite as far as its wall. A site in the gap would keep a place free
  /// that is nobody's.
  bool between_wall_and_soil(const Vec3& point, const LatticePlaces& places) {
    const double dx = scene_.spacing;
    const auto near = surface_.near(point, 0.5 * dx, search_);
    return std::any_of(near.begin(), near.end(), [&](std::uint32_t face) {
      const Facet& facet = surface_.facet(face);
      const FacetCoordinates at = coordinates(facet, scene_.dimension, point);
      return at.above(facet, 0.0) && std::abs(at.depth) < 0.5 * dx &&
             places.at(places.site_of(plus(point, dx, facet.normal)));
    });
  }

  /// Everything that what moves may come to lean on: it moves by about a spacing.
  void add_neighbourhood(PackingZone& zone) {
    const double dx = scene_.spacing;
    const Vec3& first = soil_.front();
    const Vec3 origin{first[0] - 0.5 * dx, first[1] - 0.5 * dx, first[2] - 0.5 * dx};
    const LatticePlaces places(soil_, origin, dx);
    const std::vector<Site> offsets =
        offsets_within(2.0 * smoothing_ratio_of(scene_) + 1.0, scene_.dimension);
    std::vector<bool> moves(soil_.size(), false);
    for (const std::size_t k : zone.soil) moves[k] = true;
    std::set<Site> empty;
    std::set<std::size_t> standing;
    const auto look_around = [&](const Vec3& from, const auto& found_empty) {
      stop_if_asked(stop_);
      const Site here = places.site_of(from);
      for (const Site& offset : offsets) {
        Site site{};
        Vec3 point{};
        for (std::size_t a = 0; a < 3; ++a) {
          site[a] = here[a] + offset[a];
          point[a] = from[a] + static_cast<double>(offset[a]) * dx;
        }
        if (const std::optional<std::size_t> k = places.at(site)) {
          if (!moves[*k]) standing.insert(*k);
        } else if (!empty.contains(site) && !wall_between(from, point)) {
          empty.insert(site);
          if (!between_wall_and_soil(point, places)) found_empty(point);
        }
      }
    };
    for (const std::size_t k : zone.soil) {
      look_around(soil_[k], [&](const Vec3& point) {
        (is_near_askew(point) ? zone.empty_sites : zone.standing).push_back(point);
      });
    }
    const std::vector<Vec3> moving = zone.empty_sites;
    for (const Vec3& from : moving)
      look_around(from, [&](const Vec3& point) { zone.standing.push_back(point); });
    for (const std::size_t k : standing) zone.standing.push_back(soil_[k]);
  }

  const Scene& scene_;
  const WallSurface& surface_;
  const std::vector<Vec3>& soil_;
  double reach_;
  const std::function<bool()>& stop_;
  std::vector<bool> askew_;  ///< by face: the lattice does not meet it
  FacetSearch search_;
};

}  // namespace

PackingZone packing_zone(const Scene& scene, const WallSurface& surface,
                         const std::vector<Vec3>& soil, double reach,
                         const std::function<bool()>& stop) {
  return Zone(scene, surface, soil, reach, stop).find();
}

}  // namespace scarp
