// SPDX-License-Identifier: BSD-3-Clause
/// Cells over a set of points: Morton order of the points, and look-up of the points of a cell.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace scarp {

/// Integer coordinates of a cell, 21 bits each after the offset.
using CellIndex = std::array<std::int32_t, 3>;

/// Interleaves the bits of three 21-bit coordinates: points near in space become near in memory.
/// Source: Morton (1966); bit spreading by masks.
constexpr std::uint64_t morton_key(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
  const auto spread = [](std::uint64_t v) {
    v &= 0x1fffff;
    v = (v | v << 32) & 0x001f00000000ffff;
    v = (v | v << 16) & 0x001f0000ff0000ff;
    v = (v | v << 8) & 0x100f00f00f00f00f;
    v = (v | v << 4) & 0x10c30c30c30c30c3;
    v = (v | v << 2) & 0x1249249249249249;
    return v;
  };
  return spread(x) | spread(y) << 1 | spread(z) << 2;
}

/// Three coordinate arrays of points; `z` is null in 2D.
struct PointSpan {
  const double* x = nullptr;
  const double* y = nullptr;
  const double* z = nullptr;
};

/// A range of point slots that are sorted together (a material's group, or all dummies).
struct SlotRange {
  std::int64_t begin = 0;
  std::int64_t end = 0;
};

/// Points by cell. Cells form an unbounded grid; only occupied ones take memory, in a hash table.
/// Limits: coordinates beyond 2^20 cells from the lowest point are clamped to the edge cells, which
/// stay correct and only become slow.
class CellGrid {
 public:
  /// Sorts the slots of each range by Morton key of their cell, ties by slot.
  void build(int threads, const PointSpan& points, std::span<const SlotRange> ranges,
             double cell_size);

  /// Slots in Morton order, range after range.
  std::span<const std::int32_t> order() const { return order_; }
  CellIndex cell_of(double x, double y, double z) const;
  /// Appends the slots of all points in the cells low..high to `out`, range by range and cell by
  /// cell.
  void collect(const CellIndex& low, const CellIndex& high, std::vector<std::int32_t>& out) const;
  std::size_t bytes() const;

 private:
  struct Bucket {
    std::uint64_t key = empty;
    std::int32_t begin = 0;
    std::int32_t end = 0;
  };
  static constexpr std::uint64_t empty = ~std::uint64_t{0};
  void insert(std::uint64_t key, std::int32_t begin, std::int32_t end, std::vector<Bucket>& table);

  double inverse_cell_ = 1.0;
  std::array<double, 3> origin_{};
  std::vector<std::int32_t> order_;
  std::vector<std::vector<Bucket>> tables_;  ///< one per range, two thirds full, linear probing
};

}  // namespace scarp
