// SPDX-License-Identifier: BSD-3-Clause
/// Dummy particles of the walls during a run.
#include "engine/boundary/walls.hpp"

#include <algorithm>
#include <iterator>

#include "engine/parallel.hpp"
#include "kernels/pair/force_correction.hpp"
#include "kernels/pair/wall_gradient.hpp"

namespace scarp {

using namespace kernels;

Walls::Walls(const WallDummies& dummies, const std::vector<bool>& stands, double cell_size,
             double inverse_smoothing_length) {
  std::vector<std::size_t> kept;
  AlignedVector<double> axes[3];
  for (std::size_t k = 0; k < dummies.wall.size(); ++k) {
    if (!stands[dummies.wall[k]]) continue;
    kept.push_back(k);
    for (std::size_t a = 0; a < 3; ++a) axes[a].push_back(dummies.position[k][a]);
  }
  slots_ = padded(static_cast<std::int64_t>(kept.size()));
  CellGrid grid;
  const SlotRange all{0, static_cast<std::int64_t>(kept.size())};
  grid.build(1, {axes[0].data(), axes[1].data(), axes[2].data()}, {&all, 1}, cell_size);
  for (auto* components : {position_, velocity_}) {
    for (std::size_t a = 0; a < 3; ++a) components[a].assign(static_cast<std::size_t>(slots_), 0.0);
  }
  faces_.assign(static_cast<std::size_t>(slots_) * wall_record_size, 0.0);
  for (auto& component : sums_) component.assign(static_cast<std::size_t>(slots_), 0.0);
  std::vector<std::size_t> place(dummies.beside_smooth.empty() ? 0 : dummies.wall.size());
  for (std::size_t k = 0; k < kept.size(); ++k) {
    const std::size_t source = kept[static_cast<std::size_t>(grid.order()[k])];
    for (std::size_t a = 0; a < 3; ++a) position_[a][k] = dummies.position[source][a];
    double* face = faces_.data() + k * wall_record_size;
    for (std::size_t a = 0; a < 3; ++a) face[wall_normal_x + a] = dummies.normal[source][a];
    face[wall_distance] = dummies.distance[source] * inverse_smoothing_length;
    face[wall_limit] =
        dummies.near_edge[source] ? extrapolation_limit_near_edge : extrapolation_limit;
    wall_.push_back(dummies.wall[source]);
    if (!place.empty()) place[source] = k;
  }
  corner_reach_ = dummies.corner_reach;
  for (const SmoothCorner& corner : dummies.beside_smooth) {
    if (!stands[dummies.wall[corner.dummy]]) continue;
    beside_smooth_.push_back({place[corner.dummy], corner.over});
  }
}

PointSpan Walls::points() const {
  return {position_[0].data(), position_[1].data(), position_[2].data()};
}

void Walls::remember_built() {
  std::copy(std::begin(position_), std::end(position_), std::begin(built_position_));
}

void Walls::mark_built() {
  if (have_moved()) remember_built();
}

void Walls::move_to(std::span<const double> positions) {
  if (!have_moved()) remember_built();
  for (std::size_t a = 0; a < 3; ++a)
    std::copy_n(positions.begin() + static_cast<std::ptrdiff_t>(a) * count(), count(),
                position_[a].begin());
}

void Walls::move(std::size_t wall, const Vec3& step) {
  if (!have_moved()) remember_built();
  for (std::size_t k = 0; k < wall_.size(); ++k) {
    if (wall_[k] != wall) continue;
    for (std::size_t a = 0; a < 3; ++a) position_[a][k] += step[a];
  }
}

void Walls::choose_standing(const Scene& scene, const WallSurface& surface,
                            const WallPlacement& walls) {
  if (beside_smooth_.empty()) return;
  FacetSearch search;
  absent_.assign(wall_.size(), false);
  for (const SmoothCorner& corner : beside_smooth_) {
    const std::size_t k = corner.dummy;
    const Vec3 point{position_[0][k], position_[1][k], position_[2][k]};
    absent_[k] = !stands_in_corner(scene, surface, corner_reach_, corner, point, walls, search);
  }
}

void Walls::pack(Records& records, std::int64_t dummy, const WallMaterial& material,
                 const std::vector<Vec3>& wall_velocity) const {
  const auto k = static_cast<std::size_t>(dummy);
  double* r = records.record(Role::dummy, dummy);
  for (std::size_t a = 0; a < 3; ++a) {
    r[record_x + a] = position_[a][k] * material.inverse_smoothing_length;
    r[record_velocity_x + a] = wall_velocity[wall_[k]][a];
  }
  r[record_volume] = !absent_.empty() && absent_[k] ? 0.0 : material.volume;
  r[record_density] = material.density;
  r[record_sound_speed] = material.sound_speed;
}

void Walls::put_sums(Records& records, std::int64_t dummy, WallSums what, int dimension) const {
  const auto k = static_cast<std::size_t>(dummy);
  double* r = records.record(Role::dummy, dummy);
  const auto size = static_cast<std::size_t>(dimension);
  if (what == WallSums::extrapolation) {
    for (std::size_t a = 0; a < size; ++a) r[record_velocity_x + a] = velocity_[a][k];
    for (std::size_t c = 0; c < (size == 2 ? 4 : 6); ++c) r[record_stress + c] = sums_[c][k];
    return;
  }
  Tensor<double> t{};
  for (int a = 0; a < dimension; ++a) {
    for (int b = 0; b < dimension; ++b) {
      const int sum = what == WallSums::gradient ? 3 * a + b : corrected_place_of(dimension, a, b);
      t.m[a][b] = sums_[sum][k];
    }
  }
  if (what == WallSums::corrected_stress) {
    records.put_corrected_stress(records.layout()[Role::dummy].first + dummy, dimension, t);
    return;
  }
  for (int a = 0; a < dimension; ++a) {
    for (int b = 0; b < dimension; ++b) {
      const int place =
          dimension == 2 ? wall_gradient_place<2>(a, b) : wall_gradient_place<3>(a, b);
      r[record_density + place] = r[record_volume] * t.m[a][b];
    }
  }
}

void Walls::take_sums(WallSums what, int threads, const KernelTable& kernels, int dimension,
                      std::span<const std::int32_t> clusters, const WallSweepView<double>& base,
                      const WallMaterial& material, const std::vector<Vec3>& wall_velocity,
                      Records& records) {
  WallSweepView<double> view = base;
  view.faces = faces_.data();
  for (std::size_t a = 0; a < 3; ++a) view.velocity[a] = velocity_[a].data();
  for (std::size_t c = 0; c < std::size(sums_); ++c) view.sums[c] = sums_[c].data();
  const auto sweep =
      kernels.wall_sweep[static_cast<std::size_t>(what)][static_cast<std::size_t>(dimension - 2)];
  const std::int64_t size = kernels.cluster_size;
  const auto run = [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t n = begin; n < end; ++n) {
      const std::int64_t cluster = clusters[static_cast<std::size_t>(n)];
      const std::int64_t first = cluster * size, last = std::min(first + size, count());
      for (std::int64_t k = first; k < last; ++k) pack(records, k, material, wall_velocity);
      sweep(view, cluster, cluster + 1);
      for (std::int64_t k = first; k < last; ++k) put_sums(records, k, what, dimension);
    }
  };
  parallel_chunks(threads, std::ssize(clusters), 64, run);
}

std::size_t Walls::bytes() const {
  return static_cast<std::size_t>(slots_) * (16 + wall_record_size) * sizeof(double) +
         3 * built_position_[0].size() * sizeof(double) + wall_.size() * sizeof(std::size_t);
}

}  // namespace scarp
