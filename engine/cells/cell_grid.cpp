// SPDX-License-Identifier: BSD-3-Clause
/// Cells over a set of points.
#include "engine/cells/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/parallel.hpp"

namespace scarp {
namespace {

/// Cells up to here from the lowest point have coordinates of their own.
constexpr double last_cell = 0x1p52;

struct KeyedSlot {
  std::uint64_t key;
  std::int32_t slot;
};

/// Stable radix sort by key, skipping digits that are equal everywhere.
void sort_by_key(std::vector<KeyedSlot>& items, std::vector<KeyedSlot>& scratch) {
  scratch.resize(items.size());
  std::uint64_t differing = 0;
  for (const KeyedSlot& item : items) differing |= item.key ^ items.front().key;
  constexpr int bits = 11;
  for (int shift = 0; shift < 63; shift += bits) {
    constexpr std::uint64_t mask = (1u << bits) - 1;
    if ((differing >> shift & mask) == 0) continue;
    std::array<std::size_t, mask + 2> start{};
    for (const KeyedSlot& item : items) ++start[(item.key >> shift & mask) + 1];
    for (std::size_t d = 1; d < start.size(); ++d) start[d] += start[d - 1];
    for (const KeyedSlot& item : items) scratch[start[item.key >> shift & mask]++] = item;
    items.swap(scratch);
  }
}

/// A place in a table of any size below 2^32.
std::size_t home(std::uint64_t key, std::size_t size) {
  const std::uint64_t mixed = key * 0x9e3779b97f4a7c15u >> 32;
  return static_cast<std::size_t>(mixed * size >> 32);
}

}  // namespace

CellIndex CellGrid::cell_of(double x, double y, double z) const {
  const auto index = [&](double value, double origin) {
    const double cell = std::floor((value - origin) * inverse_cell_);
    // What is not a number goes to cell 0.
    return static_cast<std::int64_t>(cell > 0.0 ? std::min(cell, last_cell) : 0.0);
  };
  return {index(x, origin_[0]), index(y, origin_[1]), index(z, origin_[2])};
}

void CellGrid::insert(std::uint64_t key, std::int32_t begin, std::int32_t end,
                      std::vector<Bucket>& table) {
  std::size_t place = home(key, table.size());
  while (table[place].key != empty) place = place + 1 < table.size() ? place + 1 : 0;
  table[place] = {key, begin, end};
}

void CellGrid::build(int threads, const PointSpan& points, std::span<const SlotRange> ranges,
                     double cell_size) {
  inverse_cell_ = 1.0 / cell_size;
  const auto lowest = [&](const double* values) {
    double low = std::numeric_limits<double>::infinity();
    for (const SlotRange& range : ranges) {
      for (std::int64_t k = range.begin; values != nullptr && k < range.end; ++k)
        low = std::min(low, values[k]);
    }
    return std::isfinite(low) ? low : 0.0;
  };
  // One cell of room below, so that searches around the lowest points stay in range.
  origin_ = {lowest(points.x) - 4 * cell_size, lowest(points.y) - 4 * cell_size,
             lowest(points.z) - 4 * cell_size};
  order_.clear();
  occupied_ = 0;
  tables_.resize(ranges.size());
  std::vector<KeyedSlot> items, scratch;
  for (std::size_t r = 0; r < ranges.size(); ++r) {
    const SlotRange range = ranges[r];
    items.resize(static_cast<std::size_t>(range.end - range.begin));
    parallel_chunks(threads, range.end - range.begin, particle_chunk,
                    [&](std::int64_t begin, std::int64_t end) {
                      for (std::int64_t k = begin; k < end; ++k) {
                        const std::int64_t slot = range.begin + k;
                        const CellIndex cell = cell_of(points.x[slot], points.y[slot],
                                                       points.z ? points.z[slot] : 0.0);
                        items[static_cast<std::size_t>(k)] = {morton_key(cell),
                                                              static_cast<std::int32_t>(slot)};
                      }
                    });
    if (!items.empty()) sort_by_key(items, scratch);
    std::size_t occupied = 0;
    for (std::size_t k = 0; k < items.size(); ++k)
      occupied += k == 0 || items[k].key != items[k - 1].key;
    tables_[r].assign(occupied + occupied / 2 + 1, Bucket{});
    occupied_ += occupied;
    const auto offset = static_cast<std::int32_t>(order_.size());
    for (std::size_t k = 0; k < items.size();) {
      std::size_t end = k + 1;
      while (end < items.size() && items[end].key == items[k].key) ++end;
      insert(items[k].key, offset + static_cast<std::int32_t>(k),
             offset + static_cast<std::int32_t>(end), tables_[r]);
      k = end;
    }
    for (const KeyedSlot& item : items) order_.push_back(item.slot);
  }
}

void CellGrid::append(const std::vector<Bucket>& table, std::uint64_t key,
                      std::vector<std::int32_t>& out) const {
  for (std::size_t place = home(key, table.size()); table[place].key != empty;
       place = place + 1 < table.size() ? place + 1 : 0) {
    if (table[place].key != key) continue;
    for (std::int32_t k = table[place].begin; k < table[place].end; ++k)
      out.push_back(order_[static_cast<std::size_t>(k)]);
    return;
  }
}

void CellGrid::collect(const CellBox& box, std::vector<std::int32_t>& out) const {
  for (const std::vector<Bucket>& table : tables_) {
    for (std::int64_t z = box.low[2]; z <= box.high[2]; ++z) {
      for (std::int64_t y = box.low[1]; y <= box.high[1]; ++y) {
        for (std::int64_t x = box.low[0]; x <= box.high[0]; ++x)
          append(table, morton_key({x, y, z}), out);
      }
    }
  }
}

void CellGrid::collect(std::span<const CellIndex> cells, std::vector<std::int32_t>& out) const {
  for (const std::vector<Bucket>& table : tables_) {
    for (const CellIndex& cell : cells) append(table, morton_key(cell), out);
  }
}

std::size_t CellGrid::bytes() const {
  std::size_t sum = order_.size() * sizeof(std::int32_t);
  for (const auto& table : tables_) sum += table.size() * sizeof(Bucket);
  return sum;
}

}  // namespace scarp
