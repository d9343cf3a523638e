// SPDX-License-Identifier: BSD-3-Clause
/// Records of mirror images from those of their sources.
#include <algorithm>
#include <array>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/boundary/mirror_images.hpp"
#include "engine/parallel.hpp"
#include "kernels/pair/term_rows.hpp"
#include "kernels/tensor.hpp"

namespace scarp {
namespace {

using namespace kernels;

using geometry::dot;

constexpr std::int64_t images_per_chunk = 256;

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

}  // namespace

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

template <class Pack>
void MirrorImages::each_after_its_source(int threads, const Generations& which,
                                         const Pack& pack) const {
  std::int64_t first = 0;
  for (std::size_t generation = 0; generation < generations_.size(); ++generation) {
    const std::int64_t last = generations_[generation];
    const std::int32_t* listed = which.all ? nullptr : which.listed[generation].data();
    const std::int64_t count = which.all ? last - first : std::ssize(which.listed[generation]);
    parallel_chunks(threads, count, images_per_chunk, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t k = begin; k < end; ++k)
        pack(static_cast<std::size_t>(listed != nullptr ? listed[k] : first + k));
    });
    first = last;
  }
}

void MirrorImages::pack(int threads, Records& records, const Mirrors& mirrors,
                        const Generations& which) const {
  const std::int64_t first = records.layout()[Role::image].first;
  each_after_its_source(threads, which, [&](std::size_t g) {
    const Image& image = images_[g];
    const double weight = pack_motion(records, mirrors, g);
    double* stress = records.record(first + static_cast<std::int64_t>(g)) + record_stress;
    reflect_tensor(stress, image.normal);
    add_weight(stress, image.normal, weight, image.lateral);
  });
}

void MirrorImages::pack_corrected(int threads, Records& records, const Mirrors& mirrors,
                                  const ParticleBuffers& soil, const ParticleBuffers& ghosts,
                                  const Generations& which) const {
  const std::int64_t first = records.layout()[Role::image].first;
  const int dimension = soil.dimension();
  const std::int64_t first_ghost = records.layout()[Role::ghost].first;
  const double *moment[6], *ghost_moment[6];
  soil.components(Field::force_moment, moment);
  if (ghosts.slots() > 0) ghosts.components(Field::force_moment, ghost_moment);
  // B of an image, by all mirrors from its soil on.
  const auto inverse = [&](const auto& again, const Image& image) -> SymTensor<double> {
    const std::int64_t from = image.source;
    return rotated(from < 0             ? again(again, images_[static_cast<std::size_t>(-1 - from)])
                   : from < first_ghost ? inverse_moment(moment, from)
                                        : inverse_moment(ghost_moment, from - first_ghost),
                   reflection(image.normal));
  };
  each_after_its_source(threads, which, [&](std::size_t g) {
    const Image& image = images_[g];
    const double weight = pack_motion(records, mirrors, g);
    const Tensor<double> mirror = reflection(image.normal);
    std::array<double, 6> between{};
    add_weight(between.data(), image.normal, weight, image.lateral);
    const Tensor<double> added =
        corrected_stress(SymTensor<double>{between[xx], between[yy], between[zz], between[xy],
                                           between[yz], between[zx]},
                         inverse(inverse, image));
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
  });
}

void MirrorImages::copy_density(int threads, Records& records, const Generations& which) const {
  const std::int64_t first = records.layout()[Role::image].first;
  each_after_its_source(threads, which, [&](std::size_t g) {
    records.record(first + static_cast<std::int64_t>(g))[record_density] =
        records.record(source_record(records, g))[record_density];
  });
}

void MirrorImages::copy_material(int threads, Records& records) const {
  const std::int64_t first = records.layout()[Role::image].first;
  each_after_its_source(threads, {}, [&](std::size_t g) {
    records.material(first + static_cast<std::int64_t>(g)) =
        records.material(source_record(records, g));
  });
}

void MirrorImages::pack_second(int threads, Records& records, kernels::TermSet terms,
                               int dimension) const {
  const std::int64_t first = records.layout()[Role::image].first;
  const bool corrected = dimension == 2 && terms.has(Term::force_correction);
  each_after_its_source(threads, {}, [&](std::size_t g) {
    const std::int64_t source = source_record(records, g);
    const std::int64_t target = first + static_cast<std::int64_t>(g);
    if (records.mark(source) == 0 && records.mark(target) == 0) return;
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
  });
}

}  // namespace scarp
