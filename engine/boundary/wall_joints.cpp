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

constexpr double ahead = 0.7;  ///< cosine of the way to a facet against the way out

class Joints {
 public:
  explicit Joints(const Scene& scene)
      : scene_(scene),
        touching_(1e-6 * scene.spacing),
        widest_(scene.spacing - touching_),
        surface_(scene) {}

  Facet joined(std::uint32_t facet) {
    const Facet& f = surface_.facet(facet);
    Facet longer = f;
    const auto stretch = [&](double& length, const Vec3& tangent, double other_length,
                             const Vec3& other_tangent) {
      const Vec3 back = minus(Vec3{}, tangent);
      const Vec3 end = plus(f.origin, length, tangent);
      const double before = gap(facet, f.origin, back, other_length, other_tangent);
      const double after = gap(facet, end, tangent, other_length, other_tangent);
      longer.origin = plus(longer.origin, before, back);
      length += before + after;
    };
    stretch(longer.length_u, f.tangent_u, f.length_v, f.tangent_v);
    if (scene_.dimension == 3) stretch(longer.length_v, f.tangent_v, f.length_u, f.tangent_u);
    return longer;
  }

 private:
  /// Widest gap over the edge that begins at `start`, if every place along it has one or touches.
  double gap(std::uint32_t facet, const Vec3& start, const Vec3& outward, double length,
             const Vec3& along) {
    const bool flat = scene_.dimension == 2;
    const double places = flat ? 0.0 : std::clamp(std::ceil(length / scene_.spacing), 1.0, 1e5);
    double widest = 0.0;
    for (double k = 0.0; k <= places; ++k) {
      const Vec3 point = flat ? start : plus(start, length * k / places, along);
      const std::optional<double> here = gap_at(facet, point, outward);
      if (!here) return 0.0;
      widest = std::max(widest, *here);
    }
    return widest;
  }

  /// 0 where another facet touches; nothing where none is near ahead.
  std::optional<double> gap_at(std::uint32_t facet, const Vec3& point, const Vec3& outward) {
    std::optional<double> nearest;
    for (const std::uint32_t k : surface_.near(point, scene_.spacing, search_)) {
      if (k == facet) continue;
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
