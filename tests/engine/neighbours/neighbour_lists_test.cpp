// SPDX-License-Identifier: BSD-3-Clause
/// Neighbour lists against brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "engine/cells/cell_grid.hpp"
#include "engine/neighbours/neighbour_lists.hpp"
#include "engine/particles/particle_buffers.hpp"
#include "kernels/neighbour_block.hpp"
#include "tests/support/random_points.hpp"

namespace scarp::test {
namespace {

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
  const kernels::NeighbourView view{
      blocks.page().data(), blocks.place().data(), nullptr, nullptr, nullptr, far_record};
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
  const Points soil = random_points(777, 5), walls = random_points(300, 6),
               inner = random_points(200, 7);
  const std::int32_t first_inner = first_wall + 304;
  CellGrid soil_grid, wall_grid, inner_grid;
  const SlotRange soil_ranges[] = {{0, 400}, {400, 777}};
  const SlotRange wall_range{0, 300}, inner_range{0, 200};
  const double reach = 0.9;
  soil_grid.build(1, soil.span(), soil_ranges, 0.5 * reach);
  wall_grid.build(1, walls.span(), {&wall_range, 1}, 0.5 * reach);
  inner_grid.build(1, inner.span(), {&inner_range, 1}, 0.5 * reach);
  for (const kernels::Isa isa : kernels::available_isas()) {
    const kernels::KernelTable& table = kernels::kernels_of(isa);
    NeighbourLists::Input input;
    input.points = soil.span();
    input.ranges = soil_ranges;
    input.slots = 784;
    const ParticleSource sources[] = {{Role::owned, &soil_grid, soil.span(), first_soil},
                                      {Role::dummy, &wall_grid, walls.span(), first_wall},
                                      {Role::inner, &inner_grid, inner.span(), first_inner}};
    input.sources = sources;
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
          records_in(view, view.wall_begin[cluster], view.wall_end[cluster]);
      const std::multiset<std::int32_t> near_inner =
          records_in(view, view.wall_end[cluster], view.soil_begin[cluster + 1]);
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
      expect_listed(inner, 200, first_inner, near_inner);
      // Records of a page stand together, and both sets lie in two pages at most.
      EXPECT_LE(padded_blocks(view, view.soil_begin[cluster], view.wall_begin[cluster]), 2);
      EXPECT_LE(padded_blocks(view, view.wall_begin[cluster], view.wall_end[cluster]), 2);
      EXPECT_LE(padded_blocks(view, view.wall_end[cluster], view.soil_begin[cluster + 1]), 2);
    }
  }
}

TEST(NeighbourListsThreadsTest, TheListsAreThoseOfOneThread) {
  // Several chunks, the second range begins within one; few dummies, so that most lists have none.
  const Points soil = random_points(5000, 8), walls = random_points(30, 9);
  CellGrid soil_grid, wall_grid;
  const SlotRange soil_ranges[] = {{0, 2200}, {2208, 5000}}, wall_range{0, 30};
  const double reach = 0.5;
  soil_grid.build(1, soil.span(), soil_ranges, 0.5 * reach);
  wall_grid.build(1, walls.span(), {&wall_range, 1}, 0.5 * reach);
  const kernels::KernelTable& table = kernels::kernels_of(kernels::available_isas().back());
  const ParticleSource sources[] = {{Role::owned, &soil_grid, soil.span(), 0},
                                    {Role::dummy, &wall_grid, walls.span(), 5008}};
  NeighbourLists::Input input;
  input.ranges = soil_ranges;
  input.sources = sources;
  input.far_record = 5100;
  input.reach = reach;
  input.cluster_size = table.cluster_size;
  Points padded = soil;
  for (AlignedVector<double>* axis : {&padded.x, &padded.y, &padded.z}) axis->resize(5008);
  input.points = padded.span();
  input.slots = 5008;
  const auto lists_of = [&](int threads) {
    NeighbourLists lists;
    for (int k = 0; k < 2; ++k) lists.build(threads, table, input);  // in memory that is there too
    const kernels::NeighbourView view = lists.view();
    const std::int64_t clusters = lists.clusters(), blocks = lists.entries() / kernels::entry_block;
    EXPECT_EQ(view.soil_begin[0], 0);
    EXPECT_EQ(view.soil_begin[clusters] + 2, blocks);
    std::vector<std::int64_t> all(view.page, view.page + blocks);
    all.insert(all.end(), view.place, view.place + blocks * kernels::entry_block);
    all.insert(all.end(), view.soil_begin, view.soil_begin + clusters + 1);
    all.insert(all.end(), view.wall_begin, view.wall_begin + clusters);
    all.insert(all.end(), view.wall_end, view.wall_end + clusters);
    std::vector<std::int32_t> active;
    for (std::int64_t c = 0; c < clusters; ++c) {
      if (view.soil_begin[c + 1] > view.soil_begin[c])
        active.push_back(static_cast<std::int32_t>(c));
    }
    const auto listed = lists.active_clusters();
    EXPECT_TRUE(std::equal(listed.begin(), listed.end(), active.begin(), active.end()));
    EXPECT_LT(std::ssize(active), clusters + 1);
    return all;
  };
  const std::vector<std::int64_t> one = lists_of(1);
  EXPECT_GT(one.size(), 20000u);
  for (const int threads : {2, 4, 8}) EXPECT_EQ(lists_of(threads), one) << threads;
}

TEST_P(NeighbourListsTest, ReachFurtherAroundFastPoints) {
  const auto [first_soil, first_wall] = GetParam();
  const Points soil = random_points(777, 5), walls = random_points(300, 6);
  CellGrid soil_grid, wall_grid;
  const SlotRange soil_range{0, 777}, wall_range{0, 300};
  const double reach = 0.4, more = 0.5;
  const std::vector<std::int64_t> fast{0, 401, 402, 776};
  soil_grid.build(1, soil.span(), {&soil_range, 1}, 0.5 * reach);
  wall_grid.build(1, walls.span(), {&wall_range, 1}, 0.5 * reach);
  const kernels::KernelTable& table = kernels::kernels_of(kernels::available_isas().back());
  const ParticleSource sources[] = {{Role::owned, &soil_grid, soil.span(), first_soil, fast},
                                    {Role::dummy, &wall_grid, walls.span(), first_wall}};
  NeighbourLists::Input input;
  input.points = soil.span();
  input.ranges = {&soil_range, 1};
  input.slots = 784;
  input.sources = sources;
  input.far_record = 3 * kernels::page_size;
  input.reach = reach;
  input.fast = fast;
  input.more = more;
  input.cluster_size = table.cluster_size;
  NeighbourLists lists;
  lists.build(2, table, input);
  const kernels::NeighbourView view = lists.view();
  const auto more_of = [&](std::int64_t k) {
    return std::binary_search(fast.begin(), fast.end(), k) ? more : 0.0;
  };
  for (std::int64_t i = 0; i < 777; ++i) {
    const std::int64_t cluster = i / table.cluster_size;
    const auto a = static_cast<std::size_t>(i);
    const auto expect_listed = [&](const Points& others, std::int32_t count, std::int32_t first,
                                   bool dummies) {
      const std::multiset<std::int32_t> listed =
          dummies ? records_in(view, view.wall_begin[cluster], view.wall_end[cluster])
                  : records_in(view, view.soil_begin[cluster], view.wall_begin[cluster]);
      for (std::int32_t j = 0; j < count; ++j) {
        const auto b = static_cast<std::size_t>(j);
        const double d =
            std::hypot(soil.x[a] - others.x[b], soil.y[a] - others.y[b], soil.z[a] - others.z[b]);
        const double wanted = reach + more_of(i) + (dummies ? 0.0 : more_of(j));
        if (d <= wanted) {
          EXPECT_EQ(listed.count(first + j), 1u) << i << " " << j;
        } else {
          EXPECT_LE(listed.count(first + j), 1u) << i << " " << j;
        }
      }
    };
    expect_listed(soil, 777, first_soil, false);
    expect_listed(walls, 300, first_wall, true);
  }
}

INSTANTIATE_TEST_SUITE_P(WithinAPageAndAcross, NeighbourListsTest,
                         testing::Values(std::pair{0, 784}, std::pair{2 * kernels::page_size - 400,
                                                                      kernels::page_size - 150}));

}  // namespace
}  // namespace scarp::test
