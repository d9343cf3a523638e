// SPDX-License-Identifier: BSD-3-Clause
/// Descent of the packing energy.
#include "engine/boundary/relaxed_packing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/held_zone.hpp"
#include "engine/boundary/mirror_images.hpp"
#include "engine/boundary/packing_zone.hpp"
#include "engine/cells/cell_grid.hpp"
#include "engine/parallel.hpp"
#include "engine/particles/lattice_places.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "engine/stop.hpp"

namespace scarp {
namespace {

constexpr double reach = 10.0;       ///< of what moves from a wall, in spacings
constexpr int most_rounds = 400;     ///< a bound that the tests do not come to
constexpr double enough = 1e-3;      ///< residual; a hundredth of that of a lattice askew
constexpr double momentum = 0.9;     ///< share of the last round's way that goes on
constexpr double longest_way = 0.1;  ///< of a particle in a round, in spacings
constexpr double margin = 0.3;       ///< of the lists, in spacings
constexpr std::int64_t chunk = 256;

/// A lattice bears steps of 2 (1 + momentum) over the largest curvature of E/V; disorder makes
/// close pairs stiffer, so that a step is 1 over it. The curvature is at most twice the sum of V
/// |W''| over the lattice. In spacings.
double step_of(const kernels::SmoothingForm& form, double ratio, int dimension) {
  constexpr double d = 1e-4;
  const double volume = form.normalisation(dimension) / std::pow(ratio, dimension + 2);
  double sum = 0.0;
  for (const Site& offset : offsets_within(2.0 * ratio, dimension)) {
    const double q = length_of(offset) / ratio;
    if (q < 2.0) sum += volume * std::abs(form.slope(q + d) - form.slope(q - d)) / (2.0 * d);
  }
  return 1.0 / (2.0 * sum);
}

/// Points of the zone, those that move first; then dummies; then images.
class Packing {
 public:
  Packing(const Scene& scene, const WallSurface& surface, const WallDummies& dummies, int threads)
      : scene_(scene),
        surface_(surface),
        threads_(threads),
        support_(2.0 * smoothing_length_of(scene)),
        stands_(scene.walls.size(), true),
        offset_(scene.walls.size(), Vec3{}) {
    for (std::size_t k = 0; k < dummies.position.size(); ++k) {
      if (dummies.distance[k] > 0.0) dummies_.push_back(dummies.position[k]);
    }
  }

  void add(const Vec3& point, bool moves) {
    for (std::size_t a = 0; a < 3; ++a) place_[a].push_back(point[a]);
    if (moves) ++moving_;
  }
  Vec3 point(std::size_t k) const { return {place_[0][k], place_[1][k], place_[2][k]}; }

  /// Returns the residual of the first `count` points.
  double descend(std::size_t count, const std::function<bool()>& stop) {
    zone_ = std::ssize(place_[0]);
    for (const Vec3& dummy : dummies_) add(dummy, false);
    way_.assign(static_cast<std::size_t>(moving_), Vec3{});
    sum_ = way_;
    build_lists();
    for (std::size_t k = 0; k < way_.size(); ++k) keep_off_faces(k);
    const double rate = scene_.spacing *
                        step_of(smoothing_of(scene_), smoothing_ratio_of(scene_), scene_.dimension);
    double used = margin;
    for (int round = 0;; ++round) {
      stop_if_asked(stop);
      if (used >= 0.5 * margin) {
        build_lists();
        used = 0.0;
      } else {
        place_images();
      }
      sum_gradients();
      double squares = 0.0;
      for (std::size_t k = 0; k < count; ++k) squares += geometry::dot(sum_[k], sum_[k]);
      const double residual = std::sqrt(squares / static_cast<double>(count));
      if (residual < enough || round == most_rounds) return residual;
      used += advance(rate) / scene_.spacing;
    }
  }

 private:
  PointSpan points() const { return {place_[0].data(), place_[1].data(), place_[2].data()}; }

  void build_lists() {
    const double reach_of_lists = support_ + margin * scene_.spacing;
    const WallPlacement walls{stands_, offset_};
    const SlotRange zone{0, zone_};
    const double no_k0 = 0.0;
    images_.select(threads_, {scene_, surface_, walls, reach_of_lists},
                   {points(), {&zone, 1}, {&no_k0, 1}, 0}, {}, 0.0, {});
    const std::int64_t first_image = zone_ + std::ssize(dummies_);
    const std::int64_t all = first_image + images_.count();
    for (auto& axis : place_) axis.resize(static_cast<std::size_t>(all));
    place_images();
    const SlotRange range{0, all};
    CellGrid grid;
    grid.build(threads_, points(), {&range, 1}, reach_of_lists);
    neighbours_.assign(static_cast<std::size_t>(moving_), {});
    faces_.assign(static_cast<std::size_t>(moving_), {});
    parallel_chunks(threads_, moving_, chunk, [&](std::int64_t begin, std::int64_t end) {
      std::vector<std::int32_t> found;
      FacetSearch search;
      for (std::int64_t i = begin; i < end; ++i) {
        const Vec3 at = point(static_cast<std::size_t>(i));
        Vec3 low, high;
        for (std::size_t a = 0; a < 3; ++a) {
          low[a] = at[a] - reach_of_lists;
          high[a] = at[a] + reach_of_lists;
        }
        const auto near = surface_.near(at, scene_.spacing, search);
        faces_[static_cast<std::size_t>(i)].assign(near.begin(), near.end());
        found.clear();
        grid.collect(grid.box_of(low, high), found);
        for (const std::int32_t j : found) {
          const Vec3 from = geometry::minus(at, point(static_cast<std::size_t>(j)));
          if (j != i && geometry::dot(from, from) < reach_of_lists * reach_of_lists)
            neighbours_[static_cast<std::size_t>(i)].push_back(j);
        }
      }
    });
  }

  void place_images() {
    images_.follow(points());
    const PointSpan from = images_.points();
    const auto first = static_cast<std::ptrdiff_t>(zone_ + std::ssize(dummies_));
    std::copy_n(from.x, images_.count(), place_[0].begin() + first);
    std::copy_n(from.y, images_.count(), place_[1].begin() + first);
    std::copy_n(from.z, images_.count(), place_[2].begin() + first);
  }

  /// sum_j V_j grad W_ij times the spacing, of what moves.
  void sum_gradients() {
    const kernels::SmoothingForm& form = smoothing_of(scene_);
    const double ratio = smoothing_ratio_of(scene_), h = ratio * scene_.spacing;
    const double volume =
        form.normalisation(scene_.dimension) / std::pow(ratio, scene_.dimension + 1);
    parallel_chunks(threads_, moving_, chunk, [&](std::int64_t begin, std::int64_t end) {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
        const Vec3 at = point(i);
        Vec3 sum{};
        for (const std::int32_t j : neighbours_[i]) {
          const Vec3 from = geometry::minus(at, point(static_cast<std::size_t>(j)));
          const double r = std::sqrt(geometry::dot(from, from));
          if (r > 0.0 && r < support_)
            sum = geometry::plus(sum, volume * form.slope(r / h) / r, from);
        }
        sum_[i] = sum;
      }
    });
  }

  /// Returns the longest way [m].
  double advance(double rate) {
    double longest = 0.0;
    for (std::size_t k = 0; k < way_.size(); ++k) {
      Vec3& way = way_[k];
      for (std::size_t a = 0; a < 3; ++a) way[a] = momentum * way[a] - rate * sum_[k][a];
      const double length = std::sqrt(geometry::dot(way, way));
      const double most = longest_way * scene_.spacing;
      for (std::size_t a = 0; a < 3; ++a) {
        if (length > most) way[a] *= most / length;
        place_[a][k] += way[a];
      }
      longest = std::max(longest, std::min(length, most));
      keep_off_faces(k);
    }
    return longest;
  }

  /// Images hold what is before their face; in a corner that is not a right one they may push
  /// across the other. Twice, because what keeps off one face may come near the other.
  void keep_off_faces(std::size_t k) {
    for (int pass = 0; pass < 2; ++pass) {
      for (const std::uint32_t face : faces_[k]) {
        const Facet& facet = surface_.facet(face);
        const auto at = geometry::coordinates(facet, scene_.dimension, point(k));
        const double deeper = at.depth + held_zone::before_face * scene_.spacing;
        if (deeper <= 0.0 || at.depth > held_zone::behind_face * scene_.spacing ||
            !at.above(facet, 0.0))
          continue;
        const double inwards = std::min(0.0, geometry::dot(way_[k], facet.normal));
        way_[k] = geometry::plus(way_[k], -inwards, facet.normal);
        for (std::size_t a = 0; a < 3; ++a) place_[a][k] += deeper * facet.normal[a];
      }
    }
  }

  const Scene& scene_;
  const WallSurface& surface_;
  int threads_;
  double support_;  ///< [m]
  std::vector<bool> stands_;
  std::vector<Vec3> offset_;
  std::vector<Vec3> dummies_;  ///< without inner points
  std::int64_t moving_ = 0, zone_ = 0;
  std::array<std::vector<double>, 3> place_;  ///< [m]
  std::vector<Vec3> way_, sum_;               ///< of what moves
  std::vector<std::vector<std::int32_t>> neighbours_;
  std::vector<std::vector<std::uint32_t>> faces_;  ///< near what moves
  MirrorImages images_;
};

}  // namespace

RelaxedPacking relax_packing(const Scene& scene, const WallSurface& surface,
                             const WallDummies& dummies, int threads,
                             const std::function<bool()>& stop, Particles& soil) {
  const PackingZone zone = packing_zone(scene, surface, soil.position, reach * scene.spacing, stop);
  if (zone.soil.empty()) return {};
  Packing packing(scene, surface, dummies, threads);
  for (const std::size_t k : zone.soil) packing.add(soil.position[k], true);
  for (const Vec3& site : zone.empty_sites) packing.add(site, true);
  for (const Vec3& point : zone.standing) packing.add(point, false);
  const double residual = packing.descend(zone.soil.size(), stop);
  for (std::size_t k = 0; k < zone.soil.size(); ++k) soil.position[zone.soil[k]] = packing.point(k);
  return {zone.soil.size(), residual};
}

}  // namespace scarp
