// SPDX-License-Identifier: BSD-3-Clause
/// How the stress of dummies varies along the normal of their wall.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/boundary/dummies.hpp"
#include "engine/particles/aligned_vector.hpp"
#include "engine/scene/scene.hpp"
#include "kernels/tensor.hpp"

namespace scarp {

/// Whether dummies have columns: where forces are corrected.
bool has_wall_columns(const Scene& scene);
/// Of an inner point from its face: there it sees two rows of soil on either side [m].
double inner_height(const Scene& scene);
/// One for each column; the positions of the dummies are those as generated.
void add_inner_points(WallDummies& dummies, double height);

/// What the wall sweep sums for each dummy, in Morton order: see `kernels::WallSweepView`.
struct DummySums {
  AlignedVector<double> sums[10];
  AlignedVector<double> weight, height, overburden;  ///< where forces are corrected

  void resize(std::int64_t slots);
  std::size_t bytes() const;
};

/// A dummy at the distance d behind its face continues what its average, at the height z over the
/// face, lacks: with the stress A n near the first dummy of its column (z_1) and near the inner
/// point (z_2), T_w = A + p I - (s (d + z)(A_2 - A_1) n/(z_2 - z_1) + s p n) (x) n, p the weight
/// of the soil along the normal. s goes from 0 to 1 as z_2 - z_1 grows from 1 to 1.3 dx: soil of
/// one or two rows has no slope that could be trusted. Equation: B6.
class WallColumns {
 public:
  WallColumns() = default;
  /// `place[k]` is the slot of dummy k of `dummies`; `no_column` if it does not stand.
  WallColumns(const WallDummies& dummies, std::span<const std::size_t> place, std::size_t slots,
              double inverse_smoothing_length, double spacing);

  bool any() const { return !columns_.empty(); }
  /// Of columns of which no soil can reach the first dummy or the inner point, by the clusters of
  /// dummies that soil reaches, nothing is summed from now on.
  void choose_active(std::span<const std::int32_t> clusters, int cluster_size);
  /// The others.
  std::span<const std::size_t> active() const { return active_; }
  /// Of them those with dummies or inner points in clusters that are wanted.
  std::vector<std::size_t> active_in(std::span<const std::uint8_t> wanted_clusters,
                                     int cluster_size) const;
  /// What the dummies of each of these columns have in common, once they have been summed: of
  /// stress, before `continue_stress`, or of velocity gradients, before `add_gradient`. `faces` has
  /// a kernels::WallSlot record for each dummy.
  template <int Dim>
  void gather_stress(int threads, std::span<const std::size_t> columns, const DummySums& sums,
                     const double* faces);
  template <int Dim>
  void gather_gradients(int threads, std::span<const std::size_t> columns, const DummySums& sums,
                        std::span<const double> standing, const double* faces);
  /// Completes the averaged stress of a dummy.
  template <int Dim>
  void continue_stress(const DummySums& sums, std::size_t dummy, const double* normal,
                       kernels::Tensor<double>& stress) const {
    const double weight = sums.overburden[dummy];
    for (std::size_t a = 0; a < Dim; ++a) stress.m[a][a] += weight;
    if (!any() || column_of_[dummy] == no_column) return;
    const Column& column = columns_[column_of_[dummy]];
    if (column.per_lever == 0.0) return;
    for (std::size_t a = 0; a < Dim; ++a) {
      const double change = -column.per_lever * (sums.height[dummy] * column.vector[a] +
                                                 column.lever * weight * normal[a]);
      for (std::size_t b = 0; b < Dim; ++b) stress.m[a][b] += change * normal[b];
    }
  }
  /// Adds to H_w of a first dummy or inner point what its column takes of the soil near it, the
  /// transpose of `continue_stress`. All dummies that stand have one volume.
  template <int Dim>
  void add_gradient(const DummySums& sums, std::size_t dummy, const double* normal, double volume,
                    kernels::Tensor<double>& gradient) const {
    if (!any() || column_of_[dummy] == no_column) return;
    const Column& column = columns_[column_of_[dummy]];
    if (dummy != column.first && dummy != column.inner) return;
    if (column.per_lever == 0.0) return;
    const double scale = volume * (dummy == column.first ? column.per_lever : -column.per_lever) /
                         sums.weight[dummy];
    for (std::size_t a = 0; a < Dim; ++a) {
      for (std::size_t b = 0; b < Dim; ++b)
        gradient.m[a][b] += scale * column.vector[a] * normal[b];
    }
  }
  /// Clusters that hold part of a column of which another part is in a wanted cluster.
  void add_partners(std::vector<std::uint8_t>& wanted_clusters, int cluster_size) const;
  std::size_t bytes() const;

 private:
  struct Column {
    std::size_t first, inner;
    std::size_t begin, end;  ///< in `members_`, without the inner point
    double lever = 0.0;      ///< z_2 - z_1 [h]
    double per_lever = 0.0;  ///< s/(z_2 - z_1); 0 without enough soil [1/h]
    /// (A_2 - A_1) n; of gradients the sum over the members of W (d + z) L n.
    Vec3 vector{};
  };
  /// Calls gather(column, normal) for each column with enough soil, whose lever is known by then.
  template <class Gather>
  void each_column(int threads, std::span<const std::size_t> columns, const DummySums& sums,
                   const double* faces, const Gather& gather);
  void set_lever(const DummySums& sums, Column& column) const;

  std::vector<Column> columns_;
  std::vector<std::size_t> active_;  ///< in `columns_`
  std::vector<std::size_t> members_;
  std::vector<std::size_t> column_of_;  ///< by dummy
  std::vector<double> distance_;        ///< by dummy, behind its face [h]
  double spacing_ = 0.0;                ///< [h]
};

}  // namespace scarp
