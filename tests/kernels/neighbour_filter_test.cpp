// SPDX-License-Identifier: BSD-3-Clause
/// Candidate test of the list build against brute force, on every instruction set.
#include <gtest/gtest.h>

#include <random>

#include "kernels/isa/kernel_table.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

struct Cloud {
  std::vector<double> x, y, z;
  void pad() {
    for (auto* axis : {&x, &y, &z}) axis->insert(axis->end(), 8, 1e8);
  }
};

TEST(NeighbourFilterTest, KeepsExactlyThePointsInReachInOrder) {
  std::mt19937 engine(4);
  std::uniform_real_distribution<double> unit(-3.0, 3.0);
  for (const Isa isa : available_isas()) {
    const KernelTable& table = kernels_of(isa);
    for (int count = 0; count < 70; ++count) {
      Cloud points, cluster;
      for (int k = 0; k < count; ++k) {
        points.x.push_back(unit(engine));
        points.y.push_back(unit(engine));
        points.z.push_back(unit(engine));
      }
      const int members = 1 + count % table.cluster_size;
      for (int k = 0; k < members; ++k) {
        cluster.x.push_back(0.5 * unit(engine));
        cluster.y.push_back(0.5 * unit(engine));
        cluster.z.push_back(0.5 * unit(engine));
      }
      const double radius_squared = 4.0;
      std::vector<std::int32_t> expected;
      for (int k = 0; k < count; ++k) {
        for (int c = 0; c < members; ++c) {
          const double dx = points.x[k] - cluster.x[c], dy = points.y[k] - cluster.y[c],
                       dz = points.z[k] - cluster.z[c];
          if (dx * dx + dy * dy + dz * dz <= radius_squared) {
            expected.push_back(k);
            break;
          }
        }
      }
      points.pad();
      std::vector<std::int32_t> kept(static_cast<std::size_t>(count) + 8, -1);
      const int found = table.filter_candidates(
          {points.x.data(), points.y.data(), points.z.data(), count, cluster.x.data(),
           cluster.y.data(), cluster.z.data(), members, radius_squared},
          kept.data());
      kept.resize(static_cast<std::size_t>(found));
      ASSERT_EQ(kept, expected) << table.name << " with " << count << " candidates";
    }
  }
}

TEST(NeighbourFilterTest, CountsThePointOnTheRim) {
  for (const Isa isa : available_isas()) {
    Cloud points{{2.0, 2.0 + 1e-12, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}};
    points.pad();
    const double origin = 0.0;
    std::int32_t kept[11];
    ASSERT_EQ(kernels_of(isa).filter_candidates({points.x.data(), points.y.data(), points.z.data(),
                                                 3, &origin, &origin, &origin, 1, 4.0},
                                                kept),
              2);
    EXPECT_EQ(kept[0], 0);
    EXPECT_EQ(kept[1], 2);
  }
}

}  // namespace
}  // namespace scarp::test
