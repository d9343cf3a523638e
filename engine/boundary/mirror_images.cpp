// SPDX-License-Identifier: BSD-3-Clause
/// Mirror images of the soil behind free-slip walls.
#include "engine/boundary/mirror_images.hpp"

#include <algorithm>
#include <cmath>

#include "engine/boundary/facet_geometry.hpp"
#include "kernels/pair/term_rows.hpp"
#include "kernels/tensor.hpp"

namespace scarp {
namespace {

using namespace kernels;

using geometry::dot;

void reflect(double* vector, const Vec3& normal, double along) {
  for (std::size_t a = 0; a < 3; ++a) vector[a] -= 2.0 * along * normal[a];
}

void reflect_tensor(double* s, const Vec3& n) {
  Tensor<double> r;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) r.m[a][b] = (a == b ? 1.0 : 0.0) - 2.0 * n[a] * n[b];
  }
  const SymTensor<double> t =
      rotated(SymTensor<double>{s[xx], s[yy], s[zz], s[xy], s[yz], s[zx]}, r);
  s[xx] = t.xx;
  s[yy] = t.yy;
  s[zz] = t.zz;
  s[xy] = t.xy;
  s[yz] = t.yz;
  s[zx] = t.zx;
}

/// Stress of the soil between a particle and its image: `weight` along the normal, K0 of it across.
void add_weight(double* s, const Vec3& n, double weight, double lateral) {
  const double across = weight * lateral, along = weight - across;
  s[xx] += across + along * n[0] * n[0];
  s[yy] += across + along * n[1] * n[1];
  s[zz] += across + along * n[2] * n[2];
  s[xy] += along * n[0] * n[1];
  s[yz] += along * n[1] * n[2];
  s[zx] += along * n[2] * n[0];
}

/// Inside the facet's footprint, which is widened by `margin` on every side.
bool in_footprint(const Facet& facet, const Vec3& from_origin, double margin) {
  const double s = dot(from_origin, facet.tangent_u), t = dot(from_origin, facet.tangent_v);
  const bool flat = facet.length_v == 0.0;
  return s >= -margin && s < facet.length_u + margin &&
         (flat || (t >= -margin && t < facet.length_v + margin));
}

}  // namespace

/// Puts a point down for every face it is near, if that comes after `after`.
void MirrorImages::ask_faces(const Scene& scene, const WallSurface& surface,
                             const WallPlacement& walls, const Vec3& point, const Source& source,
                             std::int64_t after, double reach) {
  // An image may be beyond an edge by the reach, and behind the face by as much.
  for (const std::uint32_t face : surface.near(point, std::sqrt(2.0) * reach, walls, search_)) {
    const bool smooth = scene.walls[surface.wall_of(face)].kind == WallKind::free_slip;
    if (smooth && static_cast<std::int64_t>(face) > after) asked_[face].push_back(source);
  }
}

void MirrorImages::select(const Scene& scene, const WallSurface& surface,
                          const WallPlacement& walls, const PointSpan& soil,
                          std::span<const SlotRange> ranges, std::span<const double> k0,
                          double reach, double close) {
  images_.clear();
  close_.clear();
  for (auto& axis : position_) axis.clear();
  const bool any_smooth = std::any_of(scene.walls.begin(), scene.walls.end(), [](const Wall& wall) {
    return wall.kind == WallKind::free_slip;
  });
  if (!any_smooth) return;
  const auto soil_point = [&soil](std::int64_t k) {
    return Vec3{soil.x[k], soil.y[k], soil.z != nullptr ? soil.z[k] : 0.0};
  };
  for (std::size_t r = 0; r < ranges.size(); ++r) {
    for (std::int64_t k = ranges[r].begin; k < ranges[r].end; ++k)
      ask_faces(scene, surface, walls, soil_point(k), {k, k0[r]}, -1, reach);
  }
  while (!asked_.empty()) {
    const auto first = asked_.extract(asked_.begin());
    const auto& [facet, w] = surface.faces()[first.key()];
    for (const Source& source : first.mapped()) {
      const bool is_image = source.slot < 0;
      const auto image = static_cast<std::size_t>(-1 - source.slot);
      // An image straight behind this very plane is no neighbour of it; those of other planes are.
      if (is_image && images_[image].normal == facet.normal) continue;
      const Vec3 x = is_image ? Vec3{position_[0][image], position_[1][image], position_[2][image]}
                              : soil_point(source.slot);
      Vec3 from;
      for (std::size_t a = 0; a < 3; ++a) from[a] = x[a] - facet.origin[a] - walls.offset[w][a];
      const double distance = dot(from, facet.normal);
      // Soil that has come a little behind the face keeps its image, which pushes it back.
      if (distance > reach || distance < -0.125 * reach ||
          !in_footprint(facet, from, is_image ? reach : 0.0))
        continue;
      if (!is_image && distance <= close) {
        close_.resize(static_cast<std::size_t>(ranges.back().end), 0);
        close_[static_cast<std::size_t>(source.slot)] = 1;
      }
      const std::int64_t made = count();
      images_.push_back({source.slot, w, facet.normal, facet.origin, source.lateral});
      Vec3 place;
      for (std::size_t a = 0; a < 3; ++a) {
        place[a] = x[a] - 2.0 * distance * facet.normal[a];
        position_[a].push_back(place[a]);
      }
      ask_faces(scene, surface, walls, place, {-1 - made, source.lateral}, first.key(), reach);
    }
  }
}

bool MirrorImages::is_close(std::int64_t slot, std::int64_t count) const {
  const auto last = std::min(slot + count, static_cast<std::int64_t>(close_.size()));
  return slot < last && std::any_of(close_.begin() + slot, close_.begin() + last,
                                    [](std::uint8_t close) { return close != 0; });
}

void MirrorImages::pack(Records& records, double inverse_smoothing_length,
                        const std::vector<Vec3>& wall_offset,
                        const std::vector<Vec3>& wall_velocity, const Vec3& gravity) const {
  const std::int64_t first = records.layout()[Role::image].first;
  for (std::size_t g = 0; g < images_.size(); ++g) {
    const Image& image = images_[g];
    const std::int64_t source = image.source >= 0 ? image.source : first - 1 - image.source;
    const double* from = records.record(source);
    double* to = records.record(first + static_cast<std::int64_t>(g));
    std::copy_n(from, record_size, to);
    double distance = 0.0, velocity = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      const double plane =
          (image.origin[a] + wall_offset[image.wall][a]) * inverse_smoothing_length;
      distance += (from[record_x + a] - plane) * image.normal[a];
      velocity += (from[record_velocity_x + a] - wall_velocity[image.wall][a]) * image.normal[a];
    }
    reflect(to + record_x, image.normal, distance);
    reflect(to + record_velocity_x, image.normal, velocity);
    reflect_tensor(to + record_stress, image.normal);
    // Zero on planes along gravity, which stay exact planes of symmetry.
    const double weight = 2.0 * distance / inverse_smoothing_length * from[record_density] *
                          dot(gravity, image.normal);
    add_weight(to + record_stress, image.normal, weight, image.lateral);
  }
}

void MirrorImages::pack_second(Records& records, kernels::TermSet terms) const {
  const std::int64_t first = records.layout()[Role::image].first;
  for (std::size_t g = 0; g < images_.size(); ++g) {
    const Image& image = images_[g];
    const std::int64_t source = image.source >= 0 ? image.source : first - 1 - image.source;
    const std::int64_t target = first + static_cast<std::int64_t>(g);
    if (records.mark(source) == 0 && records.mark(target) == 0) continue;
    records.mark(target) = records.mark(source);
    std::copy_n(records.second(source), second_record_size, records.second(target));
    for (const TermRow& row : term_rows) {
      if (terms.has(row.term) && row.second_slots > 0 && row.second_rank == SecondRank::tensor)
        reflect_tensor(records.second(target) + row.first_second, image.normal);
    }
  }
}

}  // namespace scarp
