// SPDX-License-Identifier: BSD-3-Clause
/// Cells against brute force, and compact clusters as permutations of blocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <vector>

#include "engine/cells/cell_grid.hpp"
#include "engine/cells/compact_clusters.hpp"
#include "engine/cells/radix_sort.hpp"
#include "tests/support/random_points.hpp"

namespace scarp::test {
namespace {

TEST(MortonTest, InterleavesBits) {
  EXPECT_EQ(morton_key({1, 0, 0}), 1u);
  EXPECT_EQ(morton_key({0, 1, 0}), 2u);
  EXPECT_EQ(morton_key({0, 0, 1}), 4u);
  EXPECT_EQ(morton_key({0b11, 0b101, 0b001}), 0b010'001'111u);  // x 011, y 101, z 001, x lowest
  EXPECT_EQ(morton_key({0x1fffff, 0x1fffff, 0x1fffff}), 0x7fffffffffffffffu);
}

/// Items in random order of which every key stands for many; `spread` tells the keys apart.
std::vector<KeyedSlot> keyed_slots(std::size_t count, std::uint64_t keys, std::uint64_t spread) {
  std::mt19937_64 random(count + keys);
  std::uniform_int_distribution<std::uint64_t> number(0, keys - 1);
  std::vector<KeyedSlot> items;
  for (std::size_t k = 0; k < count; ++k)
    items.push_back({number(random) * spread, static_cast<std::int32_t>(k)});
  return items;
}

TEST(SortByKeyTest, IsStableForAnyNumberOfItemsKeysAndThreads) {
  struct Keys {
    std::uint64_t number, spread;
  };
  constexpr std::uint64_t one = 1;
  // One key, a few, more than a digit tells apart, equal low digits, and all 63 bits.
  const Keys all_keys[] = {{1, 7}, {3, 1}, {5000, 1}, {2048, one << 33}, {one << 63, 1}};
  // The sort counts chunks of 8192.
  for (const std::size_t count : {0u, 1u, 100u, 8191u, 8192u, 8193u, 40000u}) {
    for (const Keys& keys : all_keys) {
      const std::vector<KeyedSlot> items = keyed_slots(count, keys.number, keys.spread);
      std::vector<KeyedSlot> wanted = items;
      std::stable_sort(wanted.begin(), wanted.end(),
                       [](const KeyedSlot& a, const KeyedSlot& b) { return a.key < b.key; });
      for (const int threads : {1, 2, 4, 8}) {
        RawVector<KeyedSlot> sorted(items.begin(), items.end()), scratch;
        sort_by_key(threads, sorted, scratch);
        EXPECT_TRUE(std::equal(sorted.begin(), sorted.end(), wanted.begin(), wanted.end(),
                               [](const KeyedSlot& a, const KeyedSlot& b) {
                                 return a.key == b.key && a.slot == b.slot;
                               }))
            << count << " " << keys.number << " " << threads;
      }
    }
  }
}

/// Sum over clusters of the squared diagonal of their bounding box.
double spread_of(const Points& points, const std::vector<std::int32_t>& order, std::size_t size) {
  double sum = 0.0;
  for (std::size_t first = 0; first < order.size(); first += size) {
    for (const auto* values : {&points.x, &points.y, &points.z}) {
      double low = INFINITY, high = -INFINITY;
      for (std::size_t k = first; k < std::min(first + size, order.size()); ++k) {
        low = std::min(low, (*values)[static_cast<std::size_t>(order[k])]);
        high = std::max(high, (*values)[static_cast<std::size_t>(order[k])]);
      }
      sum += (high - low) * (high - low);
    }
  }
  return sum;
}

TEST(CompactClustersTest, PermuteBlocksIntoSmallerClusters) {
  const Points points = random_points(1003, 5);
  CellGrid grid;
  const SlotRange range{0, 1003};
  grid.build(1, points.span(), {&range, 1}, 0.7);
  const std::vector<std::int32_t> morton(grid.order().begin(), grid.order().end());
  for (const int size : {2, 4, 8}) {
    std::vector<std::int32_t> one = morton, three = morton;
    compact_clusters(1, points.span(), size, one);
    compact_clusters(3, points.span(), size, three);
    EXPECT_EQ(one, three);
    for (std::size_t block = 0; block < one.size(); block += 64) {
      const auto end = static_cast<std::ptrdiff_t>(std::min(block + 64, one.size()));
      const auto begin = static_cast<std::ptrdiff_t>(block);
      const std::set<std::int32_t> before(morton.begin() + begin, morton.begin() + end);
      const std::set<std::int32_t> after(one.begin() + begin, one.begin() + end);
      EXPECT_EQ(before, after);
    }
    const auto clusters = static_cast<std::size_t>(size);
    EXPECT_LT(spread_of(points, one, clusters), spread_of(points, morton, clusters));
  }
}

TEST(CompactClustersTest, BearPositionsThatAreNotNumbers) {
  Points points = random_points(64, 6);
  std::vector<std::int32_t> order(64);
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t k = 0; k < 64; k += 3) points.x[k] = points.y[k] = points.z[k] = NAN;
  compact_clusters(1, points.span(), 4, order);
  EXPECT_EQ(std::set<std::int32_t>(order.begin(), order.end()).size(), 64u);
}

TEST(CellGridTest, OrderIsAPermutationSortedByKey) {
  const Points points = random_points(1000, 3);
  CellGrid grid;
  const SlotRange ranges[] = {{0, 600}, {608, 1000}};
  grid.build(2, points.span(), ranges, 0.7);
  std::vector<std::int32_t> order(grid.order().begin(), grid.order().end());
  ASSERT_EQ(order.size(), 992u);
  const auto key = [&](std::int32_t slot) {
    const auto k = static_cast<std::size_t>(slot);
    return morton_key(grid.cell_of(points.x[k], points.y[k], points.z[k]));
  };
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (k != 600) {
      EXPECT_LE(key(order[k - 1]), key(order[k]));
    }
  }
  EXPECT_LT(*std::max_element(order.begin(), order.begin() + 600), 600);
  EXPECT_EQ(std::set<std::int32_t>(order.begin(), order.end()).size(), 992u);
}

TEST(CellGridTest, ThreadsChangeNeitherOrderNorWhatIsFound) {
  const Points points = random_points(9000, 4);
  const SlotRange ranges[] = {{0, 5000}, {5008, 9000}};
  const auto seen = [&](int threads) {
    CellGrid grid;
    grid.build(threads, points.span(), ranges, 0.7);
    std::vector<std::int32_t> all(grid.order().begin(), grid.order().end());
    grid.collect(grid.box_of({0.0, 0.0, 0.0}, {6.0, 6.0, 6.0}), all);
    return all;
  };
  const std::vector<std::int32_t> one = seen(1);
  EXPECT_GT(one.size(), 15000u);
  for (const int threads : {2, 4, 8}) EXPECT_EQ(seen(threads), one);
}

/// Slots of the ranges whose cell lies in the box, by looking at every point.
std::multiset<std::int32_t> slots_in(const CellGrid& grid, const Points& points,
                                     std::span<const SlotRange> ranges, const CellBox& box) {
  std::multiset<std::int32_t> slots;
  for (const SlotRange& range : ranges) {
    for (std::int64_t slot = range.begin; slot < range.end; ++slot) {
      const auto k = static_cast<std::size_t>(slot);
      const CellIndex cell = grid.cell_of(points.x[k], points.y[k], points.z[k]);
      bool inside = true;
      for (std::size_t a = 0; a < 3; ++a) inside &= cell[a] >= box.low[a] && cell[a] <= box.high[a];
      if (inside) slots.insert(static_cast<std::int32_t>(slot));
    }
  }
  return slots;
}

std::multiset<std::int32_t> collected(const CellGrid& grid, const CellBox& box) {
  std::vector<std::int32_t> out;
  grid.collect(box, out);
  return {out.begin(), out.end()};
}

/// Coordinates on both sides of 0, and all negative.
class CellGridPlaceTest : public testing::TestWithParam<double> {};

TEST_P(CellGridPlaceTest, CollectsWhatBruteForceFinds) {
  Points points = random_points(1200, 11);
  for (AlignedVector<double>* axis : {&points.x, &points.y, &points.z}) {
    for (double& value : *axis) value += GetParam();
  }
  const SlotRange ranges[] = {{0, 500}, {504, 504}, {512, 1200}};
  CellGrid grid;
  grid.build(2, points.span(), ranges, 0.4);
  std::mt19937 generator(12);
  std::uniform_real_distribution<double> place(-1.0, 7.0), size(0.0, 2.5);
  std::size_t found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::array<double, 3> low, high;
    for (std::size_t a = 0; a < 3; ++a) {
      low[a] = GetParam() + place(generator);
      high[a] = low[a] + size(generator);
    }
    const CellBox box = grid.box_of(low, high);
    const std::multiset<std::int32_t> got = collected(grid, box);
    EXPECT_EQ(got, slots_in(grid, points, ranges, box));
    found += got.size();
    for (std::int32_t slot = 0; slot < 1200; ++slot) {  // whatever lies in the box itself is there
      const auto k = static_cast<std::size_t>(slot);
      const bool in_a_range = slot < 500 || slot >= 512;
      const bool inside = points.x[k] >= low[0] && points.x[k] <= high[0] &&
                          points.y[k] >= low[1] && points.y[k] <= high[1] &&
                          points.z[k] >= low[2] && points.z[k] <= high[2];
      if (inside && in_a_range) {
        EXPECT_EQ(got.count(slot), 1u) << slot;
      }
    }
  }
  EXPECT_GT(found, 1000u);  // the boxes are not empty
}
INSTANTIATE_TEST_SUITE_P(Offsets, CellGridPlaceTest, testing::Values(-3.0, -500.0, 0.0, 1e6));

TEST(CellGridTest, CellsFollowOneAnotherAtTheirSize) {
  // Half a metre and the places are exact in binary, so that no rounding decides.
  Points points;
  for (const double x : {-7.25, -2.0, 0.25, 3.5}) {
    points.x.push_back(x);
    points.y.push_back(-x);
    points.z.push_back(0.5 * x);
  }
  const SlotRange range{0, 4};
  CellGrid grid;
  grid.build(1, points.span(), {&range, 1}, 0.5);
  EXPECT_EQ(grid.occupied(), 4u);
  const CellIndex first = grid.cell_of(-7.25, -3.5, -3.625);
  for (int k = 0; k < 40; ++k) {
    const CellIndex next = grid.cell_of(-7.25 + 0.5 * k, -3.5 + 0.5 * k, -3.625 + 0.5 * k);
    for (std::size_t a = 0; a < 3; ++a) EXPECT_EQ(next[a], first[a] + k);
  }
}

TEST(CellGridTest, PlaneStrainHasOneLayerOfCells) {
  Points points = random_points(300, 13);
  const SlotRange range{0, 300};
  CellGrid grid;
  grid.build(1, {points.x.data(), points.y.data(), nullptr}, {&range, 1}, 0.5);
  points.z.assign(300, 0.0);
  const CellBox box = grid.box_of({1.0, 1.0, 0.0}, {4.0, 3.0, 0.0});
  EXPECT_EQ(box.low[2], box.high[2]);
  EXPECT_EQ(collected(grid, box), slots_in(grid, points, {&range, 1}, box));
  EXPECT_GT(collected(grid, box).size(), 20u);
}

TEST(CellGridTest, PointsFarApartAreFoundWhereTheyAre) {
  // Within the keys' reach, beyond it, and beyond what doubles tell apart.
  for (const double distance : {1e3, 3e6, 1e17}) {
    Points points;
    for (int k = 0; k < 64; ++k) {
      points.x.push_back((k < 32 ? 0.0 : distance) + 0.1 * (k % 32));
      points.y.push_back(-distance * (k % 2));
      points.z.push_back(0.0);
    }
    const SlotRange range{0, 64};
    CellGrid grid;
    grid.build(1, points.span(), {&range, 1}, 0.5);
    for (std::size_t k = 0; k < 64; ++k) {
      const std::array<double, 3> at{points.x[k], points.y[k], points.z[k]};
      const CellBox box = grid.box_of(at, at);
      EXPECT_EQ(box.count(), 1.0);
      EXPECT_EQ(collected(grid, box).count(static_cast<std::int32_t>(k)), 1u) << distance;
    }
    std::vector<std::int32_t> order(grid.order().begin(), grid.order().end());
    std::sort(order.begin(), order.end());
    for (std::int32_t k = 0; k < 64; ++k) EXPECT_EQ(order[static_cast<std::size_t>(k)], k);
  }
  const CellBox endless{{0, 0, 0}, {std::int64_t{1} << 22, 0, 0}};
  EXPECT_TRUE(std::isinf(endless.count()));
}

TEST(CellGridTest, CellsOneByOneGiveWhatTheirBoxGives) {
  const Points points = random_points(400, 14);
  const SlotRange range{0, 400};
  CellGrid grid;
  grid.build(1, points.span(), {&range, 1}, 0.8);
  const CellBox box = grid.box_of({0.5, 0.5, 0.5}, {3.0, 2.0, 4.0});
  std::vector<CellIndex> cells;
  for (std::int64_t x = box.low[0]; x <= box.high[0]; ++x) {
    for (std::int64_t y = box.low[1]; y <= box.high[1]; ++y) {
      for (std::int64_t z = box.low[2]; z <= box.high[2]; ++z) cells.push_back({x, y, z});
    }
  }
  EXPECT_EQ(box.count(), static_cast<double>(cells.size()));
  std::vector<std::int32_t> out{-1};  // what is there stays
  grid.collect(cells, out);
  EXPECT_EQ(out.front(), -1);
  EXPECT_EQ(std::multiset<std::int32_t>(out.begin() + 1, out.end()), collected(grid, box));
}

TEST(CompactClustersTest, CoincidentPointsAndPlaneStrainKeepEverySlot) {
  Points points = random_points(150, 15);
  std::fill(points.x.begin(), points.x.begin() + 70, 1.0);
  std::fill(points.y.begin(), points.y.begin() + 70, 2.0);
  std::vector<std::int32_t> order(150);
  std::iota(order.begin(), order.end(), 0);
  compact_clusters(2, {points.x.data(), points.y.data(), nullptr}, 8, order);
  // 64 equal points are a block of ties, which keep the order of their slots.
  for (std::int32_t k = 0; k < 64; k += 8) {
    const auto begin = order.begin() + k;
    EXPECT_EQ(*std::min_element(begin, begin + 8), k);
    EXPECT_EQ(*std::max_element(begin, begin + 8), k + 7);
  }
  std::sort(order.begin(), order.end());
  for (std::int32_t k = 0; k < 150; ++k) EXPECT_EQ(order[static_cast<std::size_t>(k)], k);
}

}  // namespace
}  // namespace scarp::test
