// SPDX-License-Identifier: BSD-3-Clause
/// Cells and lists against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "engine/cells/cell_grid.hpp"
#include "engine/cells/compact_clusters.hpp"
#include "engine/neighbours/neighbour_lists.hpp"
#include "engine/particles/particle_buffers.hpp"
#include "kernels/neighbour_block.hpp"

namespace scarp::test {
namespace {

struct Points {
  AlignedVector<double> x, y, z;
  PointSpan span() const { return {x.data(), y.data(), z.data()}; }
};

Points random_points(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> place(0.0, 6.0);
  Points p;
  for (std::size_t k = 0; k < count; ++k) {
    p.x.push_back(place(generator));
    p.y.push_back(place(generator));
    p.z.push_back(k % 97 == 0 ? 4000.0 + place(generator)
                              : place(generator));  // a few strays far away
  }
  return p;
}

TEST(MortonTest, InterleavesBits) {
  EXPECT_EQ(morton_key({1, 0, 0}), 1u);
  EXPECT_EQ(morton_key({0, 1, 0}), 2u);
  EXPECT_EQ(morton_key({0, 0, 1}), 4u);
  EXPECT_EQ(morton_key({0b11, 0b101, 0b001}), 0b010'001'111u);  // x 011, y 101, z 001, x lowest
  EXPECT_EQ(morton_key({0x1fffff, 0x1fffff, 0x1fffff}), 0x7fffffffffffffffu);
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

std::multiset<std::int32_t> records_in(const kernels::NeighbourView& view, std::int64_t begin,
                                       std::int64_t end) {
  std::multiset<std::int32_t> records;
  for (std::int64_t block = begin; block < end; ++block) {
    const kernels::NeighbourBlock j(view, block);
    records.insert(std::begin(j.record), std::end(j.record));
  }
  return records;
}

TEST(NeighbourBlocksTest, HoldRecordsOfAnyPageAndFillUpWithTheFarOne) {
  const std::int32_t page = kernels::page_size, far_record = 3 * page + 7;
  // First and last record of a page, a page that comes back, one record on a page of its own.
  const std::vector<std::int32_t> records{5, page - 1, page, 2 * page - 1, 0, 3 * page};
  NeighbourBlocks blocks;
  blocks.end_list();
  EXPECT_EQ(blocks.size(), 0);
  for (const std::int32_t record : records) blocks.add(record);
  blocks.end_list();
  ASSERT_EQ(blocks.size(), 4);
  for (int k = 0; k < 16; ++k) blocks.add(3 * page);
  blocks.end_list();
  EXPECT_EQ(blocks.size(), 6);  // full blocks get no padding
  blocks.append_empty(2);
  const kernels::NeighbourView view{blocks.page().data(), blocks.place().data(), nullptr, nullptr,
                                    far_record};
  std::multiset<std::int32_t> expected(records.begin(), records.end());
  for (int k = 0; k < 4 * kernels::entry_block - 6; ++k) expected.insert(far_record);
  EXPECT_EQ(records_in(view, 0, 4), expected);
  EXPECT_EQ(records_in(view, 4, 6).count(3 * page), 16u);
  EXPECT_EQ(records_in(view, 6, 8).count(far_record), 16u);
  const kernels::NeighbourBlock first(view, 0);
  EXPECT_EQ(first.record[0], 5);
  EXPECT_EQ(first.record[1], page - 1);
  EXPECT_EQ(first.record[2], far_record);
}

/// Blocks that are not full.
std::int64_t padded_blocks(const kernels::NeighbourView& view, std::int64_t begin,
                           std::int64_t end) {
  std::int64_t padded = 0;
  for (std::int64_t block = begin; block < end; ++block)
    padded += view.place[(block + 1) * kernels::entry_block - 1] == kernels::no_neighbour;
  return padded;
}

/// Lists of soil whose records begin at the first number, near dummies whose begin at the second.
class NeighbourListsTest : public testing::TestWithParam<std::pair<std::int32_t, std::int32_t>> {};

TEST_P(NeighbourListsTest, HoldEveryPairInReachOnEveryIsa) {
  const auto [first_soil, first_wall] = GetParam();
  const Points soil = random_points(777, 5), walls = random_points(300, 6);
  CellGrid soil_grid, wall_grid;
  const SlotRange soil_ranges[] = {{0, 400}, {400, 777}};
  const SlotRange wall_range{0, 300};
  const double reach = 0.9;
  soil_grid.build(1, soil.span(), soil_ranges, 0.5 * reach);
  wall_grid.build(1, walls.span(), {&wall_range, 1}, 0.5 * reach);
  for (const kernels::Isa isa : kernels::available_isas()) {
    const kernels::KernelTable& table = kernels::kernels_of(isa);
    NeighbourLists::Input input;
    input.points = soil.span();
    input.ranges = soil_ranges;
    input.slots = 784;
    input.soil = {&soil_grid, soil.span(), first_soil};
    input.walls = {&wall_grid, walls.span(), first_wall};
    input.far_record = 3 * kernels::page_size;
    input.reach = reach;
    NeighbourLists lists;
    input.cluster_size = table.cluster_size;
    lists.build(2, table, input);
    const kernels::NeighbourView view = lists.view();
    for (std::int64_t i = 0; i < 777; ++i) {
      const std::int64_t cluster = i / table.cluster_size;
      const std::multiset<std::int32_t> near_soil =
          records_in(view, view.soil_begin[cluster], view.wall_begin[cluster]);
      const std::multiset<std::int32_t> near_walls =
          records_in(view, view.wall_begin[cluster], view.soil_begin[cluster + 1]);
      const auto expect_listed = [&](const Points& others, std::int32_t count, std::int32_t first,
                                     const std::multiset<std::int32_t>& listed) {
        for (std::int32_t j = 0; j < count; ++j) {
          const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
          const double d =
              std::hypot(soil.x[a] - others.x[b], soil.y[a] - others.y[b], soil.z[a] - others.z[b]);
          if (d <= reach) {
            EXPECT_EQ(listed.count(first + j), 1u) << i << " " << j;
          }
        }
      };
      expect_listed(soil, 777, first_soil, near_soil);
      expect_listed(walls, 300, first_wall, near_walls);
      // Records of a page stand together, and both sets lie in two pages at most.
      EXPECT_LE(padded_blocks(view, view.soil_begin[cluster], view.wall_begin[cluster]), 2);
      EXPECT_LE(padded_blocks(view, view.wall_begin[cluster], view.soil_begin[cluster + 1]), 2);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(WithinAPageAndAcross, NeighbourListsTest,
                         testing::Values(std::pair{0, 784}, std::pair{2 * kernels::page_size - 400,
                                                                      kernels::page_size - 150}));

}  // namespace
}  // namespace scarp::test
