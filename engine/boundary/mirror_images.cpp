// SPDX-License-Identifier: BSD-3-Clause
/// Mirror images of the soil behind free-slip walls.
#include "engine/boundary/mirror_images.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/boundary/facet_geometry.hpp"
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

Vec3 reflected(const Vec3& point, double distance, const Vec3& normal) {
  return geometry::plus(point, -2.0 * distance, normal);
}

}  // namespace

/// Appends the images of so many sources, in their order. Notes which soil is close to a face.
template <class SourceOf>
void MirrorImages::add_images(int threads, const Mirrored& mirrored, double close,
                              std::int64_t sources, const SourceOf& source_of) {
  const Scene& scene = mirrored.scene;
  const WallSurface& surface = mirrored.surface;
  const WallPlacement& walls = mirrored.walls;
  const double reach = mirrored.reach;
  const auto each_image = [&](const Source& source, FacetSearch& search, const auto& visit) {
    const Image* from_image =
        source.record < 0 ? &images_[static_cast<std::size_t>(-1 - source.record)] : nullptr;
    // An image may be beyond an edge by the reach, and behind the face by as much.
    const double widest = std::sqrt(2.0) * (reach + source.more);
    for (const std::uint32_t face : surface.near(source.place, widest, walls, search)) {
      const auto& [facet, w] = surface.faces()[face];
      if (scene.walls[w].kind != WallKind::free_slip) continue;
      // Across several faces in their order alone. An image straight behind this very plane is no
      // neighbour of it; those of other planes are.
      if (from_image != nullptr && (face <= from_image->face || from_image->normal == facet.normal))
        continue;
      Vec3 from;
      for (std::size_t a = 0; a < 3; ++a)
        from[a] = source.place[a] - facet.origin[a] - walls.offset[w][a];
      const double distance = dot(from, facet.normal);
      // Soil that has come a little behind the face keeps its image, which pushes it back.
      if (distance > reach + source.more || distance < -0.125 * reach) continue;
      const bool is_own = from_image == nullptr && source.record < std::ssize(close_);
      if (is_own && distance <= close + source.more && in_footprint(facet, from, source.more))
        close_[static_cast<std::size_t>(source.record)] = 1;
      if (!in_footprint(facet, from, from_image != nullptr ? reach + source.more : 0.0)) continue;
      visit(Image{source.record, static_cast<std::uint32_t>(w), face, facet.normal, facet.origin,
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
        for (std::int64_t k = begin; k < end; ++k) {
          each_image(source_of(k), search, [&out](const Image& image, const Vec3& place) {
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
        return Source{soil->first_record + slot, soil->point(slot), soil->k0[r], more};
      });
    }
  }
  for (std::int64_t first = 0; first < count(); first = generations_.back()) {
    generations_.push_back(count());
    add_images(threads, mirrored, close, count() - first, [&](std::int64_t k) {
      const auto g = static_cast<std::size_t>(first + k);
      const Image& image = images_[g];
      return Source{-1 - first - k,
                    {position_[0][g], position_[1][g], position_[2][g]},
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
