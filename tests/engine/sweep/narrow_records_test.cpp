// SPDX-License-Identifier: BSD-3-Clause
/// Records in single precision: how close they stay, what is padding, and how far positions reach.
#include "engine/sweep/narrow_records.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

namespace scarp::test {
namespace {

using namespace kernels;

/// Wide records of `count` particles and the far record behind them.
struct Wide {
  AlignedVector<double> values;
  std::int64_t count;

  explicit Wide(std::int64_t particles) : values((particles + 1) * record_size), count(particles) {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> place(-900.0, 900.0), any(-3e5, 3e5);
    for (std::int64_t k = 0; k < count; ++k) {
      for (int slot = 0; slot < record_size; ++slot)
        at(k, slot) = slot < record_volume ? place(generator) : any(generator);
    }
    at(count, record_x) = 1e8;
    at(count, record_density) = 1.0;
  }
  double& at(std::int64_t record, int slot) {
    return values[static_cast<std::size_t>(record * record_size + slot)];
  }
  PairSweepView<double> view() const {
    PairSweepView<double> out{};
    out.records = values.data();
    return out;
  }
};

double place_of(const PairSweepView<float>& view, std::int64_t record, int axis) {
  const float bits = view.records[record * record_size + record_x + axis];
  return position_step * std::bit_cast<std::int32_t>(bits);
}

TEST(NarrowRecordsTest, PositionsAreIntegersAndAllElseFloats) {
  Wide wide(500);
  NarrowRecords narrow;
  const PairSweepView<float> view = narrow.narrow(2, wide.view(), wide.count);
  EXPECT_FALSE(narrow.out_of_reach());
  for (std::int64_t k = 0; k < wide.count; ++k) {
    for (int a = 0; a < 3; ++a) {
      // Rounded to the nearest step of 2^-18, from the first record; the subtraction rounds to
      // 2^-53 of 2000.
      EXPECT_NEAR(place_of(view, k, a), wide.at(k, record_x + a) - wide.at(0, record_x + a),
                  0x1p-19 + 1e-12);
    }
    for (int slot = record_volume; slot < record_size; ++slot) {
      const double exact = wide.at(k, slot);
      EXPECT_NEAR(static_cast<double>(view.records[k * record_size + slot]), exact,
                  0x1p-24 * std::fabs(exact));
    }
  }
}

TEST(NarrowRecordsTest, ASceneFarFromTheOriginIsAsCloseAsOneAtIt) {
  Wide here(100), there(100);
  // Whole steps, so that nothing is rounded: the same integers.
  constexpr double shift = 0x1p20;
  for (Wide* wide : {&here, &there}) {
    for (std::int64_t k = 0; k < 100; ++k) {
      for (int a = 0; a < 3; ++a) {
        double& x = wide->at(k, record_x + a);
        x = std::floor(x) + 0.25 + (wide == &there ? shift : 0.0);
      }
    }
  }
  NarrowRecords first, second;
  const PairSweepView<float> a = first.narrow(1, here.view(), 100);
  const PairSweepView<float> b = second.narrow(1, there.view(), 100);
  for (std::int64_t k = 0; k < 100; ++k) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_EQ(place_of(a, k, axis), place_of(b, k, axis));
  }
}

TEST(NarrowRecordsTest, PaddingIsBeyondTheSupportOfAllAndDifferencesFit) {
  Wide wide(64);
  wide.at(20, record_x) = 1e8;  // padding among the particles, as behind a material
  NarrowRecords narrow;
  const PairSweepView<float> view = narrow.narrow(1, wide.view(), wide.count);
  EXPECT_FALSE(narrow.out_of_reach());
  for (const std::int64_t padding : {std::int64_t{20}, wide.count}) {
    for (std::int64_t k = 0; k < wide.count; ++k) {
      if (k == 20) continue;
      const double apart = place_of(view, padding, 0) - place_of(view, k, 0);
      EXPECT_GT(apart, 2.0);                                // support, in units of h
      EXPECT_LE(apart / position_step, double{INT32_MAX});  // as a difference of integers
    }
  }
}

TEST(NarrowRecordsTest, TheFirstRecordOutOfReachIsTold) {
  Wide wide(3000);  // several chunks
  for (const std::int64_t far : {2999, 1500}) {
    wide.at(far, record_x + 1) = wide.at(0, record_x + 1) - position_reach;
    NarrowRecords narrow;
    narrow.narrow(3, wide.view(), wide.count);
    ASSERT_TRUE(narrow.out_of_reach());
    EXPECT_EQ(*narrow.out_of_reach(), far);
  }
  wide.at(1500, record_x + 1) = wide.at(2999, record_x + 1) =
      wide.at(0, record_x + 1) + position_reach - 1.0;  // just within
  NarrowRecords narrow;
  narrow.narrow(3, wide.view(), wide.count);
  EXPECT_FALSE(narrow.out_of_reach());
}

TEST(NarrowRecordsTest, OnlyRecordsThatAreReadAreMadeAndJudged) {
  Wide wide(100);
  NarrowRecords narrow;
  narrow.narrow(1, wide.view(), wide.count);
  // 40 of soil, 48 dummies of which two clusters are read, the others, the far record.
  const std::int32_t clusters[] = {1, 4};
  const RecordsRead read{40, {}, 48, clusters, 8};
  const auto is_read = [](std::int64_t k) {
    return k < 40 || (k >= 48 && k < 56) || (k >= 72 && k < 80) || k >= 88;
  };
  for (std::int64_t k = 0; k < wide.count; ++k) wide.at(k, record_volume) = 7.0;
  wide.at(50, record_x) = wide.at(0, record_x) + position_reach;
  const PairSweepView<float> view = narrow.narrow(2, wide.view(), wide.count, read);
  for (std::int64_t k = 0; k < wide.count; ++k)
    EXPECT_EQ(view.records[k * record_size + record_volume] == 7.0f, is_read(k)) << k;
  EXPECT_EQ(narrow.out_of_reach(), std::optional<std::int64_t>(50));
  wide.at(50, record_x) = wide.at(0, record_x);
  wide.at(66, record_x) = wide.at(0, record_x) + position_reach;  // of a cluster that is not read
  narrow.narrow(2, wide.view(), wide.count, read);
  EXPECT_FALSE(narrow.out_of_reach());
}

}  // namespace
}  // namespace scarp::test
