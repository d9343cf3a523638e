// SPDX-License-Identifier: BSD-3-Clause
/// Cells over a set of points: Morton order of the points, and look-up of the points of a cell.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/particles/aligned_vector.hpp"

namespace scarp {

struct KeyedSlot;

/// Integer coordinates of a cell; cells that are 2^21 apart along an axis share their points.
using CellIndex = std::array<std::int64_t, 3>;

/// Bits of a cell's coordinate that tell it from others.
inline constexpr std::int64_t cell_mask = 0x1fffff;

/// Interleaves the low 21 bits of three coordinates: points near in space become near in memory.
/// Source: Morton (1966); bit spreading by masks.
constexpr std::uint64_t morton_key(const CellIndex& cell) {
  const auto spread = [](std::int64_t index) {
    auto v = static_cast<std::uint64_t>(index & cell_mask);
    v = (v | v << 32) & 0x001f00000000ffff;
    v = (v | v << 16) & 0x001f0000ff0000ff;
    v = (v | v << 8) & 0x100f00f00f00f00f;
    v = (v | v << 4) & 0x10c30c30c30c30c3;
    v = (v | v << 2) & 0x1249249249249249;
    return v;
  };
  return spread(cell[0]) | spread(cell[1]) << 1 | spread(cell[2]) << 2;
}

/// The cells low .. high of every axis.
struct CellBox {
  CellIndex low{}, high{};
  /// How many there are; infinite if a side is so long that some share their points.
  double count() const {
    double product = 1.0;
    for (std::size_t a = 0; a < 3; ++a) {
      const std::int64_t side = high[a] - low[a] + 1;
      product *=
          side > cell_mask ? std::numeric_limits<double>::infinity() : static_cast<double>(side);
    }
    return product;
  }
};

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
/// Points 2^21 cells apart may come back as one cell's: callers look at distances anyway. Limits:
/// coordinates beyond 2^52 cells, where doubles no longer tell cells apart, share the outermost.
class CellGrid {
 public:
  /// Sorts the slots of each range by Morton key of their cell, ties by slot.
  void build(int threads, const PointSpan& points, std::span<const SlotRange> ranges,
             double cell_size);

  /// Slots in Morton order, range after range.
  std::span<const std::int32_t> order() const { return order_; }
  CellIndex cell_of(double x, double y, double z) const;
  CellBox box_of(const std::array<double, 3>& low, const std::array<double, 3>& high) const {
    return {cell_of(low[0], low[1], low[2]), cell_of(high[0], high[1], high[2])};
  }
  /// Appends the slots of all points in the cells of `wanted` to `out`, range by range and cell by
  /// cell; points that are no numbers may be left out. Pre: its count is finite.
  void collect(const CellBox& wanted, std::vector<std::int32_t>& out) const;
  /// The same for cells one by one, in the order given. Pre: no two have the same key.
  void collect(std::span<const CellIndex> cells, std::vector<std::int32_t>& out) const;
  /// How many cells hold points, those of several ranges counted for each.
  std::size_t occupied() const { return occupied_; }
  std::size_t bytes() const;

 private:
  struct Bucket {
    std::uint64_t key;
    std::int32_t begin, end;
  };
  using Table = RawVector<Bucket>;
  static constexpr std::uint64_t empty = ~std::uint64_t{0};
  void place_points(int threads, const PointSpan& points, std::span<const SlotRange> ranges,
                    double cell_size);
  /// The cells of a range, whose slots go behind those that `order_` has.
  void fill_table(int threads, const RawVector<KeyedSlot>& items, Table& table);
  void append(const Table& table, std::uint64_t key, std::vector<std::int32_t>& out) const;
  static void insert(const Bucket& cell, Table& table);

  double inverse_cell_ = 1.0;
  std::array<double, 3> origin_{};
  CellBox occupied_box_;  ///< around all points that are numbers
  std::size_t occupied_ = 0;
  RawVector<std::int32_t> order_;
  std::vector<Table> tables_;  ///< one per range, two thirds full, linear probing
};

}  // namespace scarp
