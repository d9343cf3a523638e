// SPDX-License-Identifier: BSD-3-Clause
/// Closes gaps between walls that no grain passes.
#include "engine/boundary/wall_joints.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/wall_surface.hpp"

namespace scarp {

using namespace geometry;

namespace {

constexpr double ahead = 0.7;        ///< cosine of the way to a facet against the way out
constexpr double most_places = 1e6;  ///< looked at along an edge on the way of a wall

class Joints {
 public:
  explicit Joints(const Scene& scene)
      : scene_(scene),
        touching_(1e-6 * scene.spacing),
        widest_(scene.spacing - touching_),
        surface_(scene) {}

  Facet joined(std::uint32_t facet) {
    const Facet& f = surface_.facet(facet);
    const Vec3& velocity = scene_.walls[surface_.wall_of(facet)].velocity;
    Facet longer = f;
    const auto stretch = [&](double& length, const Vec3& tangent, double other_length,
                             const Vec3& other_tangent) {
      const Vec3 back = minus(Vec3{}, tangent);
      const Vec3 end = plus(f.origin, length, tangent);
      const double before =
          gap_on_way(facet, f.origin, back, other_length, other_tangent, velocity);
      const double after = gap_on_way(facet, end, tangent, other_length, other_tangent, velocity);
      longer.origin = plus(longer.origin, before, back);
      length += before + after;
    };
    stretch(longer.length_u, f.tangent_u, f.length_v, f.tangent_v);
    if (scene_.dimension == 3) stretch(longer.length_v, f.tangent_v, f.length_u, f.tangent_u);
    return longer;
  }

 private:
  /// Widest gap at the start and at every place where a wall that slides past others comes by,
  /// looked for every half spacing of its way. A wall that is lifted off another one leaves it.
  double gap_on_way(std::uint32_t facet, const Vec3& start, const Vec3& outward, double length,
                    const Vec3& along, const Vec3& velocity) {
    double widest = gap(facet, start, outward, length, along, false);
    const double speed = std::sqrt(dot(velocity, velocity));
    if (speed == 0.0 || std::abs(dot(velocity, outward)) > (1.0 - ahead) * speed) return widest;
    const Vec3 half_spacing = plus(Vec3{}, 0.5 * scene_.spacing / speed, velocity);
    const double places = std::min(std::ceil(way(half_spacing)), most_places / points(length));
    for (double k = 1.0; k <= places; ++k)
      widest =
          std::max(widest, gap(facet, plus(start, k, half_spacing), outward, length, along, true));
    return widest;
  }

  /// From the first to the last corner of all walls along `step`, in its lengths.
  double way(const Vec3& step) const {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Wall& wall : scene_.walls) {
      for (const Facet& f : wall.facets) {
        for (const double u : {0.0, f.length_u}) {
          for (const double v : {0.0, f.length_v}) {
            const Vec3 corner = plus(plus(f.origin, u, f.tangent_u), v, f.tangent_v);
            const double at = dot(corner, step) / dot(step, step);
            least = std::min(least, at);
            most = std::max(most, at);
          }
        }
      }
    }
    return most - least;
  }

  /// Intervals between the places along an edge.
  double points(double length) const {
    if (scene_.dimension == 2) return 1.0;
    return std::clamp(std::ceil(length / scene_.spacing), 1.0, 1e5);
  }

  /// Widest gap over the edge that begins at `start`, if every place along it has one or touches;
  /// `later`: to walls that stand, because the others have moved by then.
  double gap(std::uint32_t facet, const Vec3& start, const Vec3& outward, double length,
             const Vec3& along, bool later) {
    const bool flat = scene_.dimension == 2;
    const double places = flat ? 0.0 : points(length);
    double widest = 0.0;
    for (double k = 0.0; k <= places; ++k) {
      const Vec3 point = flat ? start : plus(start, length * k / places, along);
      const std::optional<double> here = gap_at(facet, point, outward, later);
      if (!here) return 0.0;
      widest = std::max(widest, *here);
    }
    return widest;
  }

  /// 0 where another facet touches; nothing where none is near ahead.
  std::optional<double> gap_at(std::uint32_t facet, const Vec3& point, const Vec3& outward,
                               bool later) {
    std::optional<double> nearest;
    for (const std::uint32_t k : surface_.near(point, scene_.spacing, search_)) {
      if (k == facet) continue;
      if (later && scene_.walls[surface_.wall_of(k)].velocity != Vec3{}) continue;
      const Facet& other = surface_.facet(k);
      const FacetCoordinates at = coordinates(other, scene_.dimension, point);
      const double distance = at.distance(other);
      if (distance <= touching_) return 0.0;
      const double abreast = dot(minus(at.foot(other), point), outward);
      if (distance > widest_ || abreast < ahead * distance) continue;
      // Straight on to its plane, unless that meets it beyond its end.
      const double slope = dot(other.normal, outward);
      const double straight = std::abs(slope) > 0.1 ? at.depth / slope : 0.0;
      const bool meets =
          straight > 0.0 && coordinates(other, scene_.dimension, plus(point, straight, outward))
                                .above(other, touching_);
      const double own = meets ? straight : abreast;
      nearest = std::min(nearest.value_or(std::numeric_limits<double>::infinity()), own);
    }
    return nearest;
  }

  const Scene& scene_;
  double touching_, widest_;
  WallSurface surface_;
  FacetSearch search_;
};

}  // namespace

void close_narrow_gaps(Scene& scene) {
  Joints joints(scene);
  std::vector<std::vector<Facet>> joined;
  std::uint32_t facet = 0;
  for (const Wall& wall : scene.walls) {
    joined.emplace_back();
    for (std::size_t k = 0; k < wall.facets.size(); ++k)
      joined.back().push_back(joints.joined(facet++));
  }
  for (std::size_t w = 0; w < joined.size(); ++w) scene.walls[w].facets = std::move(joined[w]);
}

}  // namespace scarp
