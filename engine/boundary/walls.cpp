// SPDX-License-Identifier: BSD-3-Clause
/// Dummy particles of the walls during a run.
#include "engine/boundary/walls.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

#include "engine/cells/compact_clusters.hpp"
#include "engine/parallel.hpp"
#include "kernels/pair/force_correction.hpp"
#include "kernels/pair/wall_gradient.hpp"

namespace scarp {

using namespace kernels;

namespace {

/// Dummies in the order of `order`, one layer behind another, then inner points; of each layer
/// those side by side share clusters. Deep layers see less soil than those at the face, and often
/// none.
std::vector<std::int32_t> by_layer(std::vector<std::int32_t> order, const PointSpan& points,
                                   std::span<const double> distance, double spacing) {
  const auto layer = [&](std::int32_t n) {
    const double behind = distance[static_cast<std::size_t>(n)];
    return behind > 0.0 ? std::floor(behind / spacing) : std::numeric_limits<double>::infinity();
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::int32_t a, std::int32_t b) { return layer(a) < layer(b); });
  for (auto begin = order.begin(); begin != order.end();) {
    const double here = layer(*begin);
    const auto end =
        std::find_if(begin, order.end(), [&](std::int32_t n) { return layer(n) != here; });
    // Clusters of any instruction set are two or more of these.
    compact_clusters(1, points, 2, {begin, end});
    begin = end;
  }
  return order;
}

}  // namespace

Walls::Walls(const WallDummies& dummies, const std::vector<bool>& stands, double cell_size,
             double inverse_smoothing_length, double spacing) {
  std::vector<std::size_t> kept;
  AlignedVector<double> axes[3];
  std::vector<double> distance;
  for (std::size_t k = 0; k < dummies.wall.size(); ++k) {
    if (!stands[dummies.wall[k]]) continue;
    kept.push_back(k);
    for (std::size_t a = 0; a < 3; ++a) axes[a].push_back(dummies.position[k][a]);
    distance.push_back(dummies.distance[k]);
    ++(dummies.distance[k] > 0.0 ? dummy_count_ : inner_count_);
  }
  CellGrid grid;
  const SlotRange all{0, std::ssize(kept)};
  const PointSpan standing{axes[0].data(), axes[1].data(), axes[2].data()};
  grid.build(1, standing, {&all, 1}, cell_size);
  const auto size = static_cast<std::size_t>(slots());
  for (auto* components : {position_, velocity_}) {
    for (std::size_t a = 0; a < 3; ++a) components[a].assign(size, 0.0);
  }
  faces_.assign(size * wall_record_size, 0.0);
  sums_.resize(slots());
  wall_.assign(size, no_wall);
  standing_.assign(size, 0.0);
  std::vector<std::size_t> place(dummies.wall.size(), no_column);
  std::size_t next_dummy = 0, next_inner = static_cast<std::size_t>(dummy_slots());
  const auto order = grid.order();
  for (const std::int32_t n : by_layer({order.begin(), order.end()}, standing, distance, spacing)) {
    const std::size_t source = kept[static_cast<std::size_t>(n)];
    const bool is_dummy = dummies.distance[source] > 0.0;
    const std::size_t k = is_dummy ? next_dummy++ : next_inner++;
    for (std::size_t a = 0; a < 3; ++a) position_[a][k] = dummies.position[source][a];
    double* face = faces_.data() + k * wall_record_size;
    for (std::size_t a = 0; a < 3; ++a) face[wall_normal_x + a] = dummies.normal[source][a];
    face[wall_distance] = dummies.distance[source] * inverse_smoothing_length;
    face[wall_limit] =
        dummies.near_edge[source] ? extrapolation_limit_near_edge : extrapolation_limit;
    wall_[k] = dummies.wall[source];
    standing_[k] = is_dummy ? 1.0 : 0.0;
    place[source] = k;
  }
  for (const std::int32_t n : order) order_.push_back(place[kept[static_cast<std::size_t>(n)]]);
  columns_ = WallColumns(dummies, place, size, inverse_smoothing_length, spacing);
  corner_reach_ = dummies.corner_reach;
  for (const SmoothCorner& corner : dummies.beside_smooth) {
    if (!stands[dummies.wall[corner.dummy]]) continue;
    beside_smooth_.push_back({place[corner.dummy], corner.over});
  }
}

PointSpan Walls::points_from(std::int64_t slot) const {
  return {position_[0].data() + slot, position_[1].data() + slot, position_[2].data() + slot};
}

std::vector<double> Walls::in_order(const AlignedVector<double> (&from)[3]) const {
  std::vector<double> out;
  out.reserve(3 * order_.size());
  for (const AlignedVector<double>& axis : from) {
    for (const std::size_t slot : order_) out.push_back(axis[slot]);
  }
  return out;
}

void Walls::remember_built() {
  std::copy(std::begin(position_), std::end(position_), std::begin(built_position_));
}

void Walls::mark_built(std::span<const std::int32_t> clusters, int cluster_size) {
  stand_as_built_ = true;
  if (have_moved()) remember_built();
  std::fill(sums_.weight.begin(), sums_.weight.end(), 0.0);
  columns_.choose_active(clusters, cluster_size);
}

void Walls::move_to(std::span<const double> positions) {
  if (!have_moved()) remember_built();
  stand_as_built_ = false;
  auto value = positions.begin();
  for (AlignedVector<double>& axis : position_) {
    for (const std::size_t slot : order_) axis[slot] = *value++;
  }
}

void Walls::move(int threads, std::size_t wall, const Vec3& step) {
  if (!have_moved()) remember_built();
  stand_as_built_ = false;
  parallel_chunks(
      threads, std::ssize(wall_), particle_chunk, [&](std::int64_t begin, std::int64_t end) {
        for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
          if (wall_[k] != wall) continue;
          for (std::size_t a = 0; a < 3; ++a) position_[a][k] += step[a];
        }
      });
}

void Walls::choose_standing(const Scene& scene, const WallSurface& surface,
                            const WallPlacement& walls) {
  if (beside_smooth_.empty()) return;
  FacetSearch search;
  for (const SmoothCorner& corner : beside_smooth_) {
    const std::size_t k = corner.dummy;
    const Vec3 point{position_[0][k], position_[1][k], position_[2][k]};
    const bool stands =
        stands_in_corner(scene, surface, corner_reach_, corner, point, walls, search);
    standing_[k] = stands ? 1.0 : 0.0;
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
  r[record_volume] = standing_[k] * material.volume;
  r[record_density] = material.density;
  r[record_sound_speed] = material.sound_speed;
}

void Walls::put_density(int threads, Records& records, double density) const {
  parallel_chunks(threads, dummy_count_, particle_chunk, [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t k = begin; k < end; ++k)
      records.record(Role::dummy, k)[record_density] = density;
  });
}

template <int Dim>
void Walls::put_sums(Records& records, std::int64_t dummy, WallSums what,
                     const WallMaterial& material) const {
  const auto k = static_cast<std::size_t>(dummy);
  double* r = records.record(Role::dummy, dummy);
  if (what == WallSums::extrapolation) {
    for (std::size_t a = 0; a < Dim; ++a) r[record_velocity_x + a] = velocity_[a][k];
    for (std::size_t c = 0; c < (Dim == 2 ? 4 : 6); ++c) r[record_stress + c] = sums_.sums[c][k];
    return;
  }
  const double* normal = faces_.data() + k * wall_record_size + wall_normal_x;
  Tensor<double> t{};
  if (what == WallSums::corrected_stress) {
    for (int a = 0; a < Dim; ++a) {
      for (int b = 0; b < Dim; ++b) t.m[a][b] = sums_.sums[corrected_place<Dim>(a, b)][k];
    }
    columns_.continue_stress<Dim>(sums_, k, normal, t);
    records.put_corrected_stress<Dim>(records.layout()[Role::dummy].first + dummy, t);
    return;
  }
  if (dummy < dummy_count_) {  // an inner point takes part in its column alone
    for (int a = 0; a < Dim; ++a) {
      for (int b = 0; b < Dim; ++b) t.m[a][b] = r[record_volume] * sums_.sums[3 * a + b][k];
    }
  }
  columns_.add_gradient<Dim>(sums_, k, normal, material.volume, t);
  for (int a = 0; a < Dim; ++a) {
    for (int b = 0; b < Dim; ++b) r[record_density + wall_gradient_place<Dim>(a, b)] = t.m[a][b];
  }
}

void Walls::take_sums(WallSums what, int threads, const KernelTable& kernels, int dimension,
                      const Chosen& chosen, const WallSweepView<double>& base,
                      const WallMaterial& material, const std::vector<Vec3>& wall_velocity,
                      Records& records) {
  WallSweepView<double> view = base;
  view.faces = faces_.data();
  for (std::size_t a = 0; a < 3; ++a) view.velocity[a] = velocity_[a].data();
  for (std::size_t c = 0; c < std::size(sums_.sums); ++c) view.sums[c] = sums_.sums[c].data();
  view.weight = sums_.weight.data();
  view.height = sums_.height.data();
  view.overburden = sums_.overburden.data();
  const auto sweep_of = [&](WallSums sums) {
    return kernels
        .wall_sweep[static_cast<std::size_t>(sums)][static_cast<std::size_t>(dimension - 2)];
  };
  const auto sweep = sweep_of(what),
             inner_sweep = what == WallSums::gradient ? sweep_of(WallSums::weight) : sweep;
  const std::int64_t size = kernels.cluster_size, first_inner = dummy_slots() / size;
  const auto each_cluster = [&](const auto& visit) {
    const std::span<const std::int32_t> clusters = chosen.clusters;
    parallel_chunks(threads, std::ssize(clusters), 64, [&](std::int64_t begin, std::int64_t end) {
      for (std::int64_t n = begin; n < end; ++n) {
        const std::int64_t cluster = clusters[static_cast<std::size_t>(n)];
        const SlotRange range = cluster < first_inner ? dummies() : inner();
        visit(cluster, cluster * size, std::min((cluster + 1) * size, range.end));
      }
    });
  };
  each_cluster([&](std::int64_t cluster, std::int64_t first, std::int64_t last) {
    for (std::int64_t k = first; k < last; ++k) pack(records, k, material, wall_velocity);
    (cluster < first_inner ? sweep : inner_sweep)(view, cluster, cluster + 1);
  });
  // A column takes sums of other clusters.
  const auto put = [&](auto dim) {
    constexpr int Dim = decltype(dim)::value;
    if (what == WallSums::corrected_stress)
      columns_.gather_stress<Dim>(threads, chosen.columns, sums_, faces_.data());
    if (what == WallSums::gradient)
      columns_.gather_gradients<Dim>(threads, chosen.columns, sums_, standing_, faces_.data());
    each_cluster([&](std::int64_t cluster, std::int64_t first, std::int64_t last) {
      // No force is summed over inner points.
      if (what == WallSums::corrected_stress && cluster >= first_inner) return;
      for (std::int64_t k = first; k < last; ++k) put_sums<Dim>(records, k, what, material);
    });
  };
  if (dimension == 2) {
    put(std::integral_constant<int, 2>());
  } else {
    put(std::integral_constant<int, 3>());
  }
}

std::size_t Walls::bytes() const {
  return static_cast<std::size_t>(slots()) * (6 + wall_record_size) * sizeof(double) +
         sums_.bytes() + columns_.bytes() + 3 * built_position_[0].size() * sizeof(double) +
         (wall_.size() + order_.size()) * sizeof(std::size_t);
}

}  // namespace scarp
