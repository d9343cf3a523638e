// SPDX-License-Identifier: BSD-3-Clause
/// Cells over a set of points.
#include "engine/cells/cell_grid.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "engine/cells/radix_sort.hpp"
#include "engine/parallel.hpp"

namespace scarp {
namespace {

/// Cells up to here from the lowest point have coordinates of their own.
constexpr double last_cell = 0x1p52;

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

/// Threads claim buckets by their key. Where a cell comes to lie may depend on who was first; what
/// is found does not.
void CellGrid::insert(const Bucket& cell, Table& table) {
  for (std::size_t place = home(cell.key, table.size());;
       place = place + 1 < table.size() ? place + 1 : 0) {
    std::uint64_t free = empty;
    if (!std::atomic_ref(table[place].key).compare_exchange_strong(free, cell.key)) continue;
    table[place].begin = cell.begin;
    table[place].end = cell.end;
    return;
  }
}

void CellGrid::place_points(int threads, const PointSpan& points, std::span<const SlotRange> ranges,
                            double cell_size) {
  constexpr double none = std::numeric_limits<double>::infinity();
  struct Extent {
    double low = none, high = -none;
  };
  std::array<double, 3> lowest{}, highest{};
  const double* const axes[3] = {points.x, points.y, points.z};
  for (std::size_t a = 0; a < 3 && axes[a] != nullptr; ++a) {
    Extent extent;
    for (const SlotRange& range : ranges) {
      extent = parallel_reduce(
          threads, range.end - range.begin, particle_chunk, extent,
          [&](std::int64_t begin, std::int64_t end) {
            Extent here;  // whatever is no number stays out
            for (std::int64_t k = range.begin + begin; k < range.begin + end; ++k) {
              here.low = std::min(here.low, axes[a][k]);
              here.high = std::max(here.high, axes[a][k]);
            }
            return here;
          },
          [](Extent& all, const Extent& part) {
            all.low = std::min(all.low, part.low);
            all.high = std::max(all.high, part.high);
          });
    }
    lowest[a] = std::isfinite(extent.low) ? extent.low : 0.0;
    highest[a] = std::max(extent.high, lowest[a]);
  }
  // Room below, so that searches around the lowest points stay in range.
  for (std::size_t a = 0; a < 3; ++a) origin_[a] = lowest[a] - 4 * cell_size;
  occupied_box_ = box_of(lowest, highest);
}

void CellGrid::fill_table(int threads, const RawVector<KeyedSlot>& items, Table& table) {
  const auto offset = static_cast<std::int32_t>(order_.size());
  const auto begins_cell = [&](std::size_t k) {
    return k == 0 || items[k].key != items[k - 1].key;
  };
  const std::size_t occupied = parallel_reduce(
      threads, std::ssize(items), particle_chunk, std::size_t{0},
      [&](std::int64_t begin, std::int64_t end) {
        std::size_t cells = 0;
        for (std::int64_t k = begin; k < end; ++k)
          cells += begins_cell(static_cast<std::size_t>(k)) ? 1 : 0;
        return cells;
      },
      [](std::size_t& all, std::size_t part) { all += part; });
  occupied_ += occupied;
  table.clear();
  table.resize(occupied + occupied / 2 + 1);
  parallel_chunks(threads, std::ssize(table), particle_chunk,
                  [&](std::int64_t begin, std::int64_t end) {
                    std::fill(table.begin() + begin, table.begin() + end, Bucket{empty, 0, 0});
                  });
  order_.resize(order_.size() + items.size());
  parallel_chunks(
      threads, std::ssize(items), particle_chunk, [&](std::int64_t first, std::int64_t last) {
        for (auto k = static_cast<std::size_t>(first); k < static_cast<std::size_t>(last); ++k) {
          order_[static_cast<std::size_t>(offset) + k] = items[k].slot;
          if (!begins_cell(k)) continue;
          std::size_t end = k + 1;
          while (end < items.size() && items[end].key == items[k].key) ++end;
          insert({items[k].key, offset + static_cast<std::int32_t>(k),
                  offset + static_cast<std::int32_t>(end)},
                 table);
        }
      });
}

void CellGrid::build(int threads, const PointSpan& points, std::span<const SlotRange> ranges,
                     double cell_size) {
  inverse_cell_ = 1.0 / cell_size;
  place_points(threads, points, ranges, cell_size);
  order_.clear();
  occupied_ = 0;
  tables_.resize(ranges.size());
  RawVector<KeyedSlot> items, scratch;
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
    sort_by_key(threads, items, scratch);
    fill_table(threads, items, tables_[r]);
  }
}

void CellGrid::append(const Table& table, std::uint64_t key, std::vector<std::int32_t>& out) const {
  for (std::size_t place = home(key, table.size()); table[place].key != empty;
       place = place + 1 < table.size() ? place + 1 : 0) {
    if (table[place].key != key) continue;
    for (std::int32_t k = table[place].begin; k < table[place].end; ++k)
      out.push_back(order_[static_cast<std::size_t>(k)]);
    return;
  }
}

void CellGrid::collect(const CellBox& wanted, std::vector<std::int32_t>& out) const {
  CellBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    box.low[a] = std::max(wanted.low[a], occupied_box_.low[a]);
    box.high[a] = std::min(wanted.high[a], occupied_box_.high[a]);
  }
  for (const Table& table : tables_) {
    for (std::int64_t z = box.low[2]; z <= box.high[2]; ++z) {
      for (std::int64_t y = box.low[1]; y <= box.high[1]; ++y) {
        for (std::int64_t x = box.low[0]; x <= box.high[0]; ++x)
          append(table, morton_key({x, y, z}), out);
      }
    }
  }
}

void CellGrid::collect(std::span<const CellIndex> cells, std::vector<std::int32_t>& out) const {
  for (const Table& table : tables_) {
    for (const CellIndex& cell : cells) append(table, morton_key(cell), out);
  }
}

std::size_t CellGrid::bytes() const {
  std::size_t sum = order_.size() * sizeof(std::int32_t);
  for (const auto& table : tables_) sum += table.size() * sizeof(Bucket);
  return sum;
}

}  // namespace scarp
