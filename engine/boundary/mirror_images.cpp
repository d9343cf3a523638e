// SPDX-License-Identifier: BSD-3-Clause
/// Mirror images of the soil behind free-slip walls.
#include "engine/boundary/mirror_images.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/held_zone.hpp"
#include "engine/parallel.hpp"

namespace scarp {
namespace {

using geometry::dot;

/// Inside the facet's footprint, which is widened by `margin` on every side.
bool in_footprint(const Facet& facet, const Vec3& from_origin, double margin) {
  const double s = dot(from_origin, facet.tangent_u), t = dot(from_origin, facet.tangent_v);
  const bool flat = facet.length_v == 0.0;
  return s >= -margin && s < facet.length_u + margin &&
         (flat || (t >= -margin && t < facet.length_v + margin));
}

constexpr double rounding = 1e-6;  ///< of a distance, over the reach

/// Faces that soil is before, each place once.
class Places {
 public:
  explicit Places(double tolerance) : tolerance_(tolerance) {}

  void clear() { taken_.clear(); }
  /// Returns whether no face in the same plane had been taken. `distance`: of the soil from it.
  bool take(const Vec3& normal, double distance) {
    for (const auto& [other, at] : taken_) {
      if (dot(normal, other) > 1.0 - rounding && std::abs(distance - at) < tolerance_) return false;
    }
    taken_.emplace_back(normal, distance);
    return true;
  }

 private:
  double tolerance_;
  std::vector<std::pair<Vec3, double>> taken_;
};

Vec3 reflected(const Vec3& point, double distance, const Vec3& normal) {
  return geometry::plus(point, -2.0 * distance, normal);
}

}  // namespace

/// Whether the image at `place` may have an image in this face. Across several faces in the order
/// of their numbers alone, but to and fro between two that face each other; never in the plane that
/// made it, nor, where its soil has come behind its own face, in one that is turned from that by
/// less than a right angle: both would put it back onto its soil.
bool MirrorImages::follows(const Image& image, const Vec3& place, std::uint32_t face,
                           const Facet& facet, const WallPlacement& walls) {
  const double turned = dot(image.normal, facet.normal);
  if (face <= image.last && turned > -(1.0 - rounding)) return false;
  if (turned <= rounding) return true;
  const Vec3 origin = geometry::plus(image.origin, 1.0, walls.offset[image.wall]);
  return image.normal != facet.normal && dot(geometry::minus(place, origin), image.normal) <= 0.0;
}

/// Appends the images of so many sources, in their order. Notes which soil is close to a face.
template <class SourceOf>
void MirrorImages::add_images(int threads, const Mirrored& mirrored, double close,
                              std::int64_t sources, const SourceOf& source_of) {
  const Scene& scene = mirrored.scene;
  const WallSurface& surface = mirrored.surface;
  const WallPlacement& walls = mirrored.walls;
  const double reach = mirrored.reach;
  const bool any_rough = std::any_of(scene.walls.begin(), scene.walls.end(), [](const Wall& wall) {
    return wall.kind == WallKind::no_slip;
  });
  const auto each_image = [&](const Source& source, FacetSearch& search, Places& places,
                              const auto& visit) {
    const Image* mirror =
        source.record < 0 ? &images_[static_cast<std::size_t>(-1 - source.record)] : nullptr;
    // An image may be beyond an edge by the reach, and behind the face by as much.
    const double widest = std::sqrt(2.0) * (reach + source.more);
    const auto near = surface.near(source.place, widest, walls, search);
    places.clear();
    for (const std::uint32_t face : near) {  // a rough face decides where a smooth one lies too
      const auto& [facet, w] = surface.faces()[face];
      if (!any_rough || scene.walls[w].kind != WallKind::no_slip) continue;
      const Vec3 from =
          geometry::minus(source.soil, geometry::plus(facet.origin, 1.0, walls.offset[w]));
      if (in_footprint(facet, from, 0.0)) places.take(facet.normal, dot(from, facet.normal));
    }
    for (const std::uint32_t face : near) {
      const auto& [facet, w] = surface.faces()[face];
      if (scene.walls[w].kind != WallKind::free_slip) continue;
      const Vec3 origin = geometry::plus(facet.origin, 1.0, walls.offset[w]);
      // Soil behind a face is no soil of it, but for what has come a little too far and is pushed
      // back by its image.
      const Vec3 from = geometry::minus(source.soil, origin);
      const double of_soil = dot(from, facet.normal);
      if (of_soil > reach + source.more || of_soil < -held_zone::behind_face * scene.spacing)
        continue;
      const bool holds = in_footprint(facet, from, source.more);
      const bool is_own = mirror == nullptr && source.record < std::ssize(close_);
      if (is_own && of_soil <= close + source.more && holds)
        close_[static_cast<std::size_t>(source.record)] = 1;
      const Vec3 place = geometry::minus(source.place, origin);
      const double distance = dot(place, facet.normal);
      // Soil that has sunk into one face may have left the footprint of another that ends there.
      const bool is_over = mirror == nullptr
                               ? in_footprint(facet, from, 0.0)
                               : holds || (of_soil >= 0.0 && in_footprint(facet, place, 0.0));
      if (!is_over || !places.take(facet.normal, of_soil)) continue;
      if (mirror != nullptr && !follows(*mirror, source.place, face, facet, walls)) continue;
      if (distance > reach + source.more || distance < std::min(0.0, of_soil) - rounding * reach)
        continue;
      const std::uint32_t last = mirror != nullptr ? std::max(mirror->last, face) : face;
      visit(Image{source.record, static_cast<std::uint32_t>(w), last, facet.normal, facet.origin,
                  source.lateral, source.more},
            reflected(source.place, distance, facet.normal));
    }
  };
  struct PlacedImage {
    Image image;
    Vec3 place;
  };
  RawVector<PlacedImage> made;
  parallel_gather(
      threads, sources, particle_chunk, made, [&](std::int64_t begin, std::int64_t end, auto& out) {
        FacetSearch search;
        Places places(rounding * reach);
        for (std::int64_t k = begin; k < end; ++k) {
          each_image(source_of(k), search, places, [&out](const Image& image, const Vec3& place) {
            out.push_back({image, place});
          });
        }
      });
  const std::size_t first = images_.size();
  images_.resize(first + made.size());
  for (auto& axis : position_) axis.resize(first + made.size());
  parallel_chunks(
      threads, std::ssize(made), particle_chunk, [&](std::int64_t begin, std::int64_t end) {
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
          images_[first + k] = made[k].image;
          for (std::size_t a = 0; a < 3; ++a) position_[a][first + k] = made[k].place[a];
        }
      });
}

void MirrorImages::select(int threads, const Mirrored& mirrored, const Soil& own,
                          const Soil& ghosts, double close, const FastGrains& fast) {
  const std::vector<Wall>& walls = mirrored.scene.walls;
  images_.clear();
  generations_.clear();
  close_.clear();
  for (auto& axis : position_) axis.clear();
  if (std::none_of(walls.begin(), walls.end(),
                   [](const Wall& wall) { return wall.kind == WallKind::free_slip; }))
    return;
  close_.resize(own.ranges.empty() ? 0 : static_cast<std::size_t>(own.ranges.back().end));
  for (const Soil* soil : {&own, &ghosts}) {
    for (std::size_t r = 0; r < soil->ranges.size(); ++r) {
      const SlotRange range = soil->ranges[r];
      add_images(threads, mirrored, close, range.end - range.begin, [&](std::int64_t k) {
        const std::int64_t slot = range.begin + k;
        const double more = soil == &own && fast.among(slot, 1) ? fast.more : 0.0;
        const Vec3 point = soil->point(slot);
        return Source{soil->first_record + slot, point, point, soil->k0[r], more};
      });
    }
  }
  const std::int64_t own_records = std::ssize(close_);
  for (std::int64_t first = 0; first < count(); first = generations_.back()) {
    generations_.push_back(count());
    add_images(threads, mirrored, close, count() - first, [&](std::int64_t k) {
      const auto g = static_cast<std::size_t>(first + k);
      const Image& image = images_[g];
      const std::int64_t record = soil_of(first + k);
      const Soil& soil = record < own_records ? own : ghosts;
      return Source{-1 - first - k,
                    {position_[0][g], position_[1][g], position_[2][g]},
                    soil.point(record - soil.first_record),
                    image.lateral,
                    image.more};
    });
  }
}

void MirrorImages::follow(const PointSpan& soil) {
  for (std::size_t g = 0; g < images_.size(); ++g) {
    const Image& image = images_[g];
    const bool of_image = image.source < 0;
    const PointSpan from = of_image ? points() : soil;
    const std::int64_t k = of_image ? -1 - image.source : image.source;
    const Vec3 x{from.x[k], from.y[k], from.z[k]};
    const double distance = dot(geometry::minus(x, image.origin), image.normal);
    const Vec3 place = reflected(x, distance, image.normal);
    for (std::size_t a = 0; a < 3; ++a) position_[a][g] = place[a];
  }
}

std::vector<std::int64_t> MirrorImages::fast(int threads) const {
  std::vector<std::int64_t> found;
  parallel_gather(threads, count(), particle_chunk, found,
                  [&](std::int64_t begin, std::int64_t end, auto& out) {
                    for (std::int64_t k = begin; k < end; ++k) {
                      if (images_[static_cast<std::size_t>(k)].more > 0.0) out.push_back(k);
                    }
                  });
  return found;
}

std::int64_t MirrorImages::soil_of(std::int64_t image) const {
  std::int64_t source = images_[static_cast<std::size_t>(image)].source;
  while (source < 0) source = images_[static_cast<std::size_t>(-1 - source)].source;
  return source;
}

MirrorImages::Generations MirrorImages::of_soil(int threads,
                                                std::span<const std::uint8_t> marked_blocks,
                                                std::int64_t slots) const {
  Generations chosen{false, {}};
  std::int64_t first = 0;
  for (const std::int64_t last : generations_) {
    const auto list = [&](std::int64_t begin, std::int64_t end, auto& out) {
      for (std::int64_t k = first + begin; k < first + end; ++k) {
        const auto block = static_cast<std::size_t>(soil_of(k) / slots);
        if (marked_blocks[block] != 0) out.push_back(static_cast<std::int32_t>(k));
      }
    };
    parallel_gather(threads, last - first, particle_chunk, chosen.listed.emplace_back(), list);
    first = last;
  }
  return chosen;
}

bool MirrorImages::is_close(std::int64_t slot, std::int64_t count) const {
  const auto last = std::min(slot + count, static_cast<std::int64_t>(close_.size()));
  return slot < last && std::any_of(close_.begin() + slot, close_.begin() + last,
                                    [](std::uint8_t close) { return close != 0; });
}

}  // namespace scarp
