// SPDX-License-Identifier: BSD-3-Clause
/// How the stress of dummies varies along the normal of their wall.
#include "engine/boundary/wall_columns.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/parallel.hpp"
#include "kernels/pair/force_correction.hpp"

namespace scarp {

using namespace kernels;

namespace {

/// Heights between which the slope of the stress is trusted, in spacings: of two rows of soil 0.9,
/// of three 1.4, of more 1.5.
constexpr double no_trust = 1.0, full_trust = 1.3;

constexpr std::int64_t columns_per_chunk = 256;

}  // namespace

bool has_wall_columns(const Scene& scene) { return scene.numerics.corrects_force(); }

double inner_height(const Scene& scene) { return 2.0 * scene.spacing; }

void add_inner_points(WallDummies& dummies, double height) {
  for (std::size_t c = 0; c < dummies.columns.size(); ++c) {
    WallColumn& column = dummies.columns[c];
    const Vec3 normal = dummies.normal[column.first];
    const double away = dummies.distance[column.first] + height;
    column.inner = dummies.position.size();
    dummies.position.push_back(geometry::plus(dummies.position[column.first], away, normal));
    dummies.normal.push_back(normal);
    dummies.distance.push_back(-height);
    dummies.wall.push_back(dummies.wall[column.first]);
    dummies.column.push_back(c);
    dummies.near_edge.push_back(false);
  }
}

void DummySums::resize(std::int64_t slots) {
  for (auto& component : sums) component.assign(static_cast<std::size_t>(slots), 0.0);
  for (auto* more : {&weight, &height, &overburden})
    more->assign(static_cast<std::size_t>(slots), 0.0);
}

std::size_t DummySums::bytes() const {
  return (10 * sums[0].size() + 3 * weight.size()) * sizeof(double);
}

WallColumns::WallColumns(const WallDummies& dummies, std::span<const std::size_t> place,
                         std::size_t slots, double inverse_smoothing_length, double spacing)
    : spacing_(spacing * inverse_smoothing_length) {
  // In the order of their first dummies, so that sums are read one after the other.
  std::vector<std::size_t> standing;
  for (std::size_t c = 0; c < dummies.columns.size(); ++c) {
    if (place[dummies.columns[c].first] != no_column) standing.push_back(c);
  }
  std::sort(standing.begin(), standing.end(), [&](std::size_t a, std::size_t b) {
    return place[dummies.columns[a].first] < place[dummies.columns[b].first];
  });
  std::vector<std::size_t> number(dummies.columns.size(), no_column);
  for (const std::size_t c : standing) {
    const WallColumn& column = dummies.columns[c];
    number[c] = columns_.size();
    columns_.push_back(
        {.first = place[column.first], .inner = place[column.inner], .begin = 0, .end = 0});
  }
  if (columns_.empty()) return;
  column_of_.assign(slots, no_column);
  distance_.assign(slots, 0.0);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;  // column and member
  for (std::size_t k = 0; k < place.size(); ++k) {
    if (place[k] == no_column) continue;
    distance_[place[k]] = dummies.distance[k] * inverse_smoothing_length;
    if (dummies.column[k] == no_column) continue;
    const std::size_t column = number[dummies.column[k]];
    column_of_[place[k]] = column;
    if (place[k] != columns_[column].inner) pairs.emplace_back(column, place[k]);
  }
  std::sort(pairs.begin(), pairs.end());
  for (const auto& [column, member] : pairs) {
    if (columns_[column].end == 0) columns_[column].begin = members_.size();
    members_.push_back(member);
    columns_[column].end = members_.size();
  }
}

void WallColumns::choose_active(std::span<const std::int32_t> clusters, int cluster_size) {
  active_.clear();
  if (columns_.empty()) return;
  std::vector<std::uint8_t> reached(column_of_.size() / static_cast<std::size_t>(cluster_size) + 1);
  for (const std::int32_t cluster : clusters) reached[static_cast<std::size_t>(cluster)] = 1;
  const auto is_reached = [&](std::size_t dummy) {
    return reached[dummy / static_cast<std::size_t>(cluster_size)] != 0;
  };
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    columns_[c].per_lever = 0.0;
    if (is_reached(columns_[c].first) && is_reached(columns_[c].inner)) active_.push_back(c);
  }
}

std::vector<std::size_t> WallColumns::active_in(std::span<const std::uint8_t> wanted_clusters,
                                                int cluster_size) const {
  std::vector<std::size_t> chosen;
  const auto is_wanted = [&](std::size_t dummy) {
    return wanted_clusters[dummy / static_cast<std::size_t>(cluster_size)] != 0;
  };
  std::copy_if(active_.begin(), active_.end(), std::back_inserter(chosen), [&](std::size_t c) {
    const Column& column = columns_[c];
    return is_wanted(column.inner) ||
           std::any_of(members_.begin() + static_cast<std::ptrdiff_t>(column.begin),
                       members_.begin() + static_cast<std::ptrdiff_t>(column.end), is_wanted);
  });
  return chosen;
}

void WallColumns::set_lever(const DummySums& sums, Column& column) const {
  column.per_lever = 0.0;
  if (sums.weight[column.first] == 0.0 || sums.weight[column.inner] == 0.0) return;
  const auto height = [&](std::size_t k) { return sums.height[k] - distance_[k]; };
  column.lever = height(column.inner) - height(column.first);
  const double x =
      std::clamp((column.lever / spacing_ - no_trust) / (full_trust - no_trust), 0.0, 1.0);
  if (x > 0.0) column.per_lever = x * x * (3.0 - 2.0 * x) / column.lever;
}

template <class Gather>
void WallColumns::each_column(int threads, std::span<const std::size_t> columns,
                              const DummySums& sums, const double* faces, const Gather& gather) {
  parallel_chunks(threads, std::ssize(columns), columns_per_chunk,
                  [&](std::int64_t begin, std::int64_t end) {
                    for (std::int64_t n = begin; n < end; ++n) {
                      Column& column = columns_[columns[static_cast<std::size_t>(n)]];
                      set_lever(sums, column);
                      if (column.per_lever != 0.0)
                        gather(column, faces + column.first * wall_record_size + wall_normal_x);
                    }
                  });
}

template <int Dim>
void WallColumns::gather_stress(int threads, std::span<const std::size_t> columns,
                                const DummySums& sums, const double* faces) {
  each_column(threads, columns, sums, faces, [&](Column& column, const double* normal) {
    for (std::size_t a = 0; a < Dim; ++a) {
      column.vector[a] = 0.0;
      for (std::size_t b = 0; b < Dim; ++b) {
        const auto& sum = sums.sums[corrected_place<Dim>(static_cast<int>(a), static_cast<int>(b))];
        column.vector[a] += (sum[column.inner] - sum[column.first]) * normal[b];
      }
    }
  });
}

template <int Dim>
void WallColumns::gather_gradients(int threads, std::span<const std::size_t> columns,
                                   const DummySums& sums, std::span<const double> standing,
                                   const double* faces) {
  each_column(threads, columns, sums, faces, [&](Column& column, const double* normal) {
    for (std::size_t a = 0; a < Dim; ++a) {
      column.vector[a] = 0.0;
      for (std::size_t m = column.begin; m < column.end; ++m) {
        const std::size_t k = members_[m];
        double along = 0.0;
        for (std::size_t b = 0; b < Dim; ++b) along += sums.sums[3 * a + b][k] * normal[b];
        column.vector[a] += standing[k] * sums.weight[k] * sums.height[k] * along;
      }
    }
  });
}

template void WallColumns::gather_stress<2>(int, std::span<const std::size_t>, const DummySums&,
                                            const double*);
template void WallColumns::gather_stress<3>(int, std::span<const std::size_t>, const DummySums&,
                                            const double*);
template void WallColumns::gather_gradients<2>(int, std::span<const std::size_t>, const DummySums&,
                                               std::span<const double>, const double*);
template void WallColumns::gather_gradients<3>(int, std::span<const std::size_t>, const DummySums&,
                                               std::span<const double>, const double*);

void WallColumns::add_partners(std::vector<std::uint8_t>& wanted_clusters, int cluster_size) const {
  const std::vector<std::uint8_t> asked = wanted_clusters;
  const auto cluster = [&](std::size_t dummy) {
    return dummy / static_cast<std::size_t>(cluster_size);
  };
  for (const Column& column : columns_) {
    const auto each = [&](const auto& visit) {
      visit(column.inner);
      for (std::size_t m = column.begin; m < column.end; ++m) visit(members_[m]);
    };
    bool any_wanted = false;
    each([&](std::size_t k) { any_wanted = any_wanted || asked[cluster(k)] != 0; });
    if (any_wanted) each([&](std::size_t k) { wanted_clusters[cluster(k)] = 1; });
  }
}

std::size_t WallColumns::bytes() const {
  return columns_.size() * sizeof(Column) +
         (active_.size() + members_.size() + column_of_.size() + distance_.size()) * sizeof(double);
}

}  // namespace scarp
