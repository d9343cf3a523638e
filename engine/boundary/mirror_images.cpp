// SPDX-License-Identifier: BSD-3-Clause
/// Mirror images of the soil behind free-slip walls.
#include "engine/boundary/mirror_images.hpp"

#include <algorithm>
#include <cmath>

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

/// Calls ask(face) for every smooth face that a point is near.
template <class Ask>
void MirrorImages::each_smooth_face(const Mirrored& mirrored, const Vec3& point, double more,
                                    FacetSearch& search, const Ask& ask) {
  // An image may be beyond an edge by the reach, and behind the face by as much.
  const double widest = std::sqrt(2.0) * (mirrored.reach + more);
  const WallSurface& surface = mirrored.surface;
  for (const std::uint32_t face : surface.near(point, widest, mirrored.walls, search)) {
    if (mirrored.scene.walls[surface.wall_of(face)].kind == WallKind::free_slip) ask(face);
  }
}

/// Puts soil down for every face it is near, in its order.
void MirrorImages::ask_faces(int threads, const Mirrored& mirrored, const Soil& soil,
                             const FastGrains* fast) {
  using Asked = std::vector<std::pair<std::uint32_t, Source>>;
  for (std::size_t r = 0; r < soil.ranges.size(); ++r) {
    const SlotRange range = soil.ranges[r];
    const Asked asked = parallel_reduce(
        threads, range.end - range.begin, particle_chunk, Asked(),
        [&](std::int64_t begin, std::int64_t end) {
          Asked here;
          FacetSearch search;
          for (std::int64_t k = range.begin + begin; k < range.begin + end; ++k) {
            const double more = fast != nullptr && fast->among(k, 1) ? fast->more : 0.0;
            const Source source{soil.first_record + k, soil.k0[r], more};
            each_smooth_face(mirrored, soil.point(k), more, search,
                             [&](std::uint32_t face) { here.emplace_back(face, source); });
          }
          return here;
        },
        [](Asked& all, const Asked& part) { all.insert(all.end(), part.begin(), part.end()); });
    for (const auto& [face, source] : asked) asked_[face].push_back(source);
  }
}

void MirrorImages::select(int threads, const Mirrored& mirrored, const Soil& own,
                          const Soil& ghosts, double close, const FastGrains& fast) {
  const auto& [scene, surface, walls, reach] = mirrored;
  images_.clear();
  generations_.clear();
  close_.clear();
  for (auto& axis : position_) axis.clear();
  const bool any_smooth = std::any_of(scene.walls.begin(), scene.walls.end(), [](const Wall& wall) {
    return wall.kind == WallKind::free_slip;
  });
  if (!any_smooth) return;
  const std::int64_t own_end = own.ranges.empty() ? 0 : own.ranges.back().end;
  const auto soil_point = [&](std::int64_t record) {
    const Soil& soil = record < own_end ? own : ghosts;
    return soil.point(record - soil.first_record);
  };
  ask_faces(threads, mirrored, own, &fast);
  ask_faces(threads, mirrored, ghosts, nullptr);
  FacetSearch search;
  while (!asked_.empty()) {
    const auto first = asked_.extract(asked_.begin());
    const auto& [facet, w] = surface.faces()[first.key()];
    for (const Source& source : first.mapped()) {
      const bool is_image = source.record < 0;
      const auto image = static_cast<std::size_t>(-1 - source.record);
      // An image straight behind this very plane is no neighbour of it; those of other planes are.
      if (is_image && images_[image].normal == facet.normal) continue;
      const Vec3 x = is_image ? Vec3{position_[0][image], position_[1][image], position_[2][image]}
                              : soil_point(source.record);
      Vec3 from;
      for (std::size_t a = 0; a < 3; ++a) from[a] = x[a] - facet.origin[a] - walls.offset[w][a];
      const double distance = dot(from, facet.normal);
      // Soil that has come a little behind the face keeps its image, which pushes it back.
      if (distance > reach + source.more || distance < -0.125 * reach) continue;
      const bool is_own = !is_image && source.record < own_end;
      if (is_own && distance <= close + source.more && in_footprint(facet, from, source.more)) {
        close_.resize(static_cast<std::size_t>(own_end), 0);
        close_[static_cast<std::size_t>(source.record)] = 1;
      }
      if (!in_footprint(facet, from, is_image ? reach + source.more : 0.0)) continue;
      const std::int64_t made = count();
      images_.push_back(
          {source.record, w, facet.normal, facet.origin, source.lateral, source.more});
      const Vec3 place = reflected(x, distance, facet.normal);
      for (std::size_t a = 0; a < 3; ++a) position_[a].push_back(place[a]);
      each_smooth_face(mirrored, place, source.more, search, [&](std::uint32_t face) {
        if (face > first.key()) asked_[face].push_back({-1 - made, source.lateral, source.more});
      });
    }
  }
  sort_by_generation();
}

/// Images of soil, images of those, and so on.
void MirrorImages::sort_by_generation() {
  std::vector<std::size_t> generation(images_.size());
  for (std::size_t g = 0; g < images_.size(); ++g) {
    const std::int64_t source = images_[g].source;
    generation[g] = source >= 0 ? 0 : generation[static_cast<std::size_t>(-1 - source)] + 1;
    if (generation[g] == generations_.size()) generations_.emplace_back();
    generations_[generation[g]].push_back(static_cast<std::int32_t>(g));
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

std::vector<std::int64_t> MirrorImages::fast() const {
  std::vector<std::int64_t> found;
  for (std::int64_t k = 0; k < count(); ++k) {
    if (images_[static_cast<std::size_t>(k)].more > 0.0) found.push_back(k);
  }
  return found;
}

std::int64_t MirrorImages::soil_of(std::int64_t image) const {
  std::int64_t source = images_[static_cast<std::size_t>(image)].source;
  while (source < 0) source = images_[static_cast<std::size_t>(-1 - source)].source;
  return source;
}

bool MirrorImages::is_close(std::int64_t slot, std::int64_t count) const {
  const auto last = std::min(slot + count, static_cast<std::int64_t>(close_.size()));
  return slot < last && std::any_of(close_.begin() + slot, close_.begin() + last,
                                    [](std::uint8_t close) { return close != 0; });
}

}  // namespace scarp
