// SPDX-License-Identifier: BSD-3-Clause
/// Cells and lists against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "engine/cells/cell_grid.hpp"
#include "engine/cells/compact_clusters.hpp"
#include "engine/neighbours/neighbour_lists.hpp"
#include "engine/particles/particle_buffers.hpp"

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
  EXPECT_EQ(morton_key(1, 0, 0), 1u);
  EXPECT_EQ(morton_key(0, 1, 0), 2u);
  EXPECT_EQ(morton_key(0, 0, 1), 4u);
  EXPECT_EQ(morton_key(0b11, 0b101, 0b001), 0b010'001'111u);  // x 011, y 101, z 001, x lowest
  EXPECT_EQ(morton_key(0x1fffff, 0x1fffff, 0x1fffff), 0x7fffffffffffffffu);
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
    const CellIndex c = grid.cell_of(points.x[k], points.y[k], points.z[k]);
    return morton_key(static_cast<std::uint32_t>(c[0]), static_cast<std::uint32_t>(c[1]),
                      static_cast<std::uint32_t>(c[2]));
  };
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (k != 600) {
      EXPECT_LE(key(order[k - 1]), key(order[k]));
    }
  }
  EXPECT_LT(*std::max_element(order.begin(), order.begin() + 600), 600);
  EXPECT_EQ(std::set<std::int32_t>(order.begin(), order.end()).size(), 992u);
}

TEST(NeighbourListsTest, HoldEveryPairInReachOnEveryIsa) {
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
    input.soil = {&soil_grid, soil.span(), 0};
    input.walls = {&wall_grid, walls.span(), 784};
    input.far_record = 2000;
    input.reach = reach;
    NeighbourLists lists;
    input.cluster_size = table.cluster_size;
    lists.build(2, table, input);
    const kernels::NeighbourView view = lists.view();
    for (std::int64_t i = 0; i < 777; ++i) {
      const std::int64_t cluster = i / table.cluster_size;
      const std::multiset<std::int32_t> near_soil(view.entries + view.soil_begin[cluster],
                                                  view.entries + view.wall_begin[cluster]);
      const std::multiset<std::int32_t> near_walls(view.entries + view.wall_begin[cluster],
                                                   view.entries + view.end[cluster]);
      EXPECT_EQ((view.wall_begin[cluster] - view.soil_begin[cluster]) % kernels::entry_block, 0);
      EXPECT_EQ((view.end[cluster] - view.wall_begin[cluster]) % kernels::entry_block, 0);
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
      expect_listed(soil, 777, 0, near_soil);
      expect_listed(walls, 300, 784, near_walls);
    }
  }
}

}  // namespace
}  // namespace scarp::test
