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

/// R = I - 2 n n^T.
Tensor<double> reflection(const Vec3& n) {
  Tensor<double> r;
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) r.m[a][b] = (a == b ? 1.0 : 0.0) - 2.0 * n[a] * n[b];
  }
  return r;
}

void reflect_tensor(double* s, const Vec3& n) {
  const SymTensor<double> t =
      rotated(SymTensor<double>{s[xx], s[yy], s[zz], s[xy], s[yz], s[zx]}, reflection(n));
  s[xx] = t.xx;
  s[yy] = t.yy;
  s[zz] = t.zz;
  s[xy] = t.xy;
  s[yz] = t.yz;
  s[zx] = t.zx;
}

/// A tensor of 2D that need not be symmetric, at the places of T.
void reflect_corrected(double* s, const Vec3& n) {
  Tensor<double> t{};
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) t.m[a][b] = s[corrected_place<2>(a, b)];
  }
  t = rotated(t, reflection(n));
  for (int a = 0; a < 2; ++a) {
    for (int b = 0; b < 2; ++b) s[corrected_place<2>(a, b)] = t.m[a][b];
  }
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
  const double widest = std::sqrt(2.0) * (reach + source.more);
  for (const std::uint32_t face : surface.near(point, widest, walls, search_)) {
    const bool smooth = scene.walls[surface.wall_of(face)].kind == WallKind::free_slip;
    if (smooth && static_cast<std::int64_t>(face) > after) asked_[face].push_back(source);
  }
}

void MirrorImages::select(const Scene& scene, const WallSurface& surface,
                          const WallPlacement& walls, const Soil& own, const Soil& ghosts,
                          double reach, double close, const FastGrains& fast) {
  images_.clear();
  close_.clear();
  for (auto& axis : position_) axis.clear();
  const bool any_smooth = std::any_of(scene.walls.begin(), scene.walls.end(), [](const Wall& wall) {
    return wall.kind == WallKind::free_slip;
  });
  if (!any_smooth) return;
  const std::int64_t own_end = own.ranges.empty() ? 0 : own.ranges.back().end;
  const auto soil_point = [&](std::int64_t record) {
    const Soil& soil = record < own_end ? own : ghosts;
    const std::int64_t k = record - soil.first_record;
    return Vec3{soil.points.x[k], soil.points.y[k],
                soil.points.z != nullptr ? soil.points.z[k] : 0.0};
  };
  for (const Soil* soil : {&own, &ghosts}) {
    for (std::size_t r = 0; r < soil->ranges.size(); ++r) {
      for (std::int64_t k = soil->ranges[r].begin; k < soil->ranges[r].end; ++k) {
        const std::int64_t record = soil->first_record + k;
        const double more = soil == &own && fast.among(k, 1) ? fast.more : 0.0;
        ask_faces(scene, surface, walls, soil_point(record), {record, soil->k0[r], more}, -1,
                  reach);
      }
    }
  }
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
      Vec3 place;
      for (std::size_t a = 0; a < 3; ++a) {
        place[a] = x[a] - 2.0 * distance * facet.normal[a];
        position_[a].push_back(place[a]);
      }
      ask_faces(scene, surface, walls, place, {-1 - made, source.lateral, source.more}, first.key(),
                reach);
    }
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

std::int64_t MirrorImages::source_record(const Records& records, std::size_t image) const {
  const std::int64_t source = images_[image].source;
  return source >= 0 ? source : records.layout()[Role::image].first - 1 - source;
}

/// Copies the record of the source, reflects its position and velocity, and returns the weight of
/// the soil between. That is zero on planes along gravity, which stay exact planes of symmetry.
double MirrorImages::pack_motion(Records& records, const Mirrors& mirrors, std::size_t g) const {
  const Image& image = images_[g];
  const double* from = records.record(source_record(records, g));
  double* to = records.record(records.layout()[Role::image].first + static_cast<std::int64_t>(g));
  std::copy_n(from, record_size, to);
  double distance = 0.0, velocity = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const double plane =
        (image.origin[a] + mirrors.wall_offset[image.wall][a]) * mirrors.inverse_smoothing_length;
    distance += (from[record_x + a] - plane) * image.normal[a];
    velocity +=
        (from[record_velocity_x + a] - mirrors.wall_velocity[image.wall][a]) * image.normal[a];
  }
  reflect(to + record_x, image.normal, distance);
  reflect(to + record_velocity_x, image.normal, velocity);
  return 2.0 * distance / mirrors.inverse_smoothing_length * from[record_density] *
         dot(mirrors.gravity, image.normal);
}

void MirrorImages::pack(Records& records, const Mirrors& mirrors) const {
  const std::int64_t first = records.layout()[Role::image].first;
  for (std::size_t g = 0; g < images_.size(); ++g) {
    const Image& image = images_[g];
    const double weight = pack_motion(records, mirrors, g);
    double* stress = records.record(first + static_cast<std::int64_t>(g)) + record_stress;
    reflect_tensor(stress, image.normal);
    add_weight(stress, image.normal, weight, image.lateral);
  }
}

void MirrorImages::pack_corrected(Records& records, const Mirrors& mirrors,
                                  const ParticleBuffers& soil,
                                  const ParticleBuffers& ghosts) const {
  const std::int64_t first = records.layout()[Role::image].first;
  const int dimension = soil.dimension();
  const std::int64_t first_ghost = records.layout()[Role::ghost].first;
  const double *moment[6], *ghost_moment[6];
  soil.components(Field::force_moment, moment);
  if (ghosts.slots() > 0) ghosts.components(Field::force_moment, ghost_moment);
  const auto moment_of_soil = [&](std::int64_t record) {
    return record < first_ghost ? inverse_moment(moment, record)
                                : inverse_moment(ghost_moment, record - first_ghost);
  };
  std::vector<SymTensor<double>> inverse(images_.size());  // B of each image
  for (std::size_t g = 0; g < images_.size(); ++g) {
    const Image& image = images_[g];
    const double weight = pack_motion(records, mirrors, g);
    const Tensor<double> mirror = reflection(image.normal);
    const SymTensor<double> of_source = image.source >= 0
                                            ? moment_of_soil(image.source)
                                            : inverse[static_cast<std::size_t>(-1 - image.source)];
    inverse[g] = rotated(of_source, mirror);
    std::array<double, 6> between{};
    add_weight(between.data(), image.normal, weight, image.lateral);
    const Tensor<double> added =
        corrected_stress(SymTensor<double>{between[xx], between[yy], between[zz], between[xy],
                                           between[yz], between[zx]},
                         inverse[g]);
    Tensor<double> t =
        rotated(records.corrected_stress(source_record(records, g), dimension), mirror);
    for (int a = 0; a < 3; ++a) {
      for (int b = 0; b < 3; ++b) t.m[a][b] += added.m[a][b];
    }
    const std::int64_t target = first + static_cast<std::int64_t>(g);
    records.put_corrected_stress(target, dimension, t);
    if (soil.has(Field::strain_rate))
      records.put_strain_rate(
          target, dimension,
          rotated(records.strain_rate(source_record(records, g), dimension), mirror));
  }
}

void MirrorImages::pack_second(Records& records, kernels::TermSet terms, int dimension) const {
  const std::int64_t first = records.layout()[Role::image].first;
  const bool corrected = dimension == 2 && terms.has(Term::force_correction);
  for (std::size_t g = 0; g < images_.size(); ++g) {
    const std::int64_t source = source_record(records, g);
    const std::int64_t target = first + static_cast<std::int64_t>(g);
    if (records.mark(source) == 0 && records.mark(target) == 0) continue;
    records.mark(target) = records.mark(source);
    for (const TermRow& row : term_rows) {
      if (!terms.has(row.term) || row.second_line == nullptr) continue;
      double* to = records.second(target) + row.first_second;
      std::copy_n(records.second(source) + row.first_second, row.second_slots, to);
      if (row.second_rank != SecondRank::tensor) continue;
      if (corrected) {
        reflect_corrected(to, images_[g].normal);
      } else {
        reflect_tensor(to, images_[g].normal);
      }
    }
  }
}

}  // namespace scarp
