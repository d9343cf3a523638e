// SPDX-License-Identifier: BSD-3-Clause
/// Dummy particles of the no-slip walls during a run: motion, removal, velocity and stress from the
/// soil.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/boundary/dummies.hpp"
#include "engine/boundary/wall_columns.hpp"
#include "engine/boundary/wall_surface.hpp"
#include "engine/cells/cell_grid.hpp"
#include "engine/neighbours/neighbour_lists.hpp"
#include "engine/particles/aligned_vector.hpp"
#include "engine/particles/particle_buffers.hpp"
#include "engine/scene/scene.hpp"
#include "engine/sweep/records.hpp"

namespace scarp {

inline constexpr std::size_t no_wall = std::numeric_limits<std::size_t>::max();

/// What dummy particles take over from the soil they touch.
struct WallMaterial {
  double density = 1.0;      ///< reference density [kg/m3]
  double sound_speed = 0.0;  ///< [m/s]
  double volume = 0.0;       ///< dx^d times RecordScaling::gradient_factor
  double inverse_smoothing_length = 0.0;
};

class Walls {
 public:
  Walls() = default;
  /// Dummies of the walls that stand, then inner points, each in Morton order.
  Walls(const WallDummies& dummies, const std::vector<bool>& stands, double cell_size,
        double inverse_smoothing_length, double spacing);

  /// Dummies and inner points.
  std::int64_t count() const { return dummy_count_ + inner_count_; }
  std::int64_t dummy_count() const { return dummy_count_; }
  /// Slots hold dummies and padding, then inner points and padding. Inner points have no volume.
  SlotRange dummies() const { return {0, dummy_count_}; }
  SlotRange inner() const { return {dummy_slots(), dummy_slots() + inner_count_}; }
  std::int64_t slots() const { return dummy_slots() + inner_slots(); }
  std::int64_t dummy_slots() const { return padded(dummy_count_); }
  std::int64_t inner_slots() const { return padded(inner_count_); }
  PointSpan points() const { return points_from(0); }
  PointSpan inner_points() const { return points_from(dummy_slots()); }
  /// ... or `no_wall` of padding.
  std::size_t wall_of(std::int64_t slot) const { return wall_[static_cast<std::size_t>(slot)]; }

  /// Moves the dummies of a wall.
  void move(int threads, std::size_t wall, const Vec3& step);
  /// Puts dummies and inner points, in one Morton order, at x of all, then y, then z.
  void move_to(std::span<const double> positions);
  /// Where they stand, or stood when the lists were built, in the same form.
  std::vector<double> positions() const { return in_order(position_); }
  std::vector<double> built_positions() const {
    return in_order(have_moved() ? built_position_ : position_);
  }
  /// The lists have been built of the present positions; dummies of other clusters than these have
  /// no soil.
  void mark_built(std::span<const std::int32_t> clusters, int cluster_size);
  bool have_moved() const { return !built_position_[0].empty(); }
  /// Whether lists have been built of the present positions.
  bool stand_as_built() const { return stand_as_built_; }

  /// Which of the dummies in corners with free-slip faces stand now; when lists are built.
  void choose_standing(const Scene& scene, const WallSurface& surface, const WallPlacement& walls);
  /// With the clusters of dummies that those in wanted clusters take sums of.
  void add_partners(std::vector<std::uint8_t>& wanted_clusters, int cluster_size) const {
    columns_.add_partners(wanted_clusters, cluster_size);
  }
  const WallColumns& columns() const { return columns_; }
  /// Clusters of dummies and inner points, and the columns of which some are in them.
  struct Chosen {
    std::span<const std::int32_t> clusters;
    std::span<const std::size_t> columns;
  };
  /// Records of the dummies that have soil in reach: position, velocity, and what the wall sweep
  /// sums of the soil, cluster by cluster. No list names the others. Equation: B1, B2, B5, B6.
  void take_sums(kernels::WallSums what, int threads, const kernels::KernelTable& kernels,
                 int dimension, const Chosen& chosen, const kernels::WallSweepView<double>& base,
                 const WallMaterial& material, const std::vector<Vec3>& wall_velocity,
                 Records& records);
  /// Another density into the records of all dummies.
  void put_density(int threads, Records& records, double density) const;
  std::size_t bytes() const;

 private:
  PointSpan points_from(std::int64_t slot) const;
  std::vector<double> in_order(const AlignedVector<double> (&from)[3]) const;
  void remember_built();
  void pack(Records& records, std::int64_t dummy, const WallMaterial& material,
            const std::vector<Vec3>& wall_velocity) const;
  template <int Dim>
  void put_sums(Records& records, std::int64_t dummy, kernels::WallSums what,
                const WallMaterial& material) const;

  std::int64_t dummy_count_ = 0, inner_count_ = 0;
  bool stand_as_built_ = false;
  std::vector<std::size_t> order_;  ///< slots of dummies and inner points in one Morton order
  AlignedVector<double> position_[3];
  AlignedVector<double> built_position_[3];  ///< empty until something moves
  AlignedVector<double> velocity_[3];
  DummySums sums_;
  WallColumns columns_;
  AlignedVector<double> faces_;  ///< kernels::WallSlot
  std::vector<std::size_t> wall_;
  std::vector<SmoothCorner> beside_smooth_;
  CornerReach corner_reach_;
  std::vector<double> standing_;  ///< 1; 0: inner points, and corners that are open now
};

}  // namespace scarp
