// SPDX-License-Identifier: BSD-3-Clause
/// Surface, front and distances of deposits of known shape.
#include "validation/deposit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "engine/errors.hpp"

namespace scarp::validation {
namespace {

constexpr double dx = 0.1;

/// x of a lattice of columns, `rows[k]` particles in the k-th.
std::vector<double> lattice(const std::vector<int>& rows) {
  std::vector<double> x;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    x.insert(x.end(), static_cast<std::size_t>(rows[k]), (static_cast<double>(k) + 0.5) * dx);
  }
  return x;
}

TEST(DepositTest, ColumnsOfABlockHaveItsHeight) {
  const Profile profile = column_profile(lattice({5, 5, 5, 5}), dx, 2 * dx);
  EXPECT_NEAR(height_at(profile, 0.0), 5 * dx, 1e-12);
  EXPECT_NEAR(height_at(profile, 0.1), 5 * dx, 1e-12);
  EXPECT_NEAR(height_at(profile, 0.3), 5 * dx, 1e-12);
  EXPECT_EQ(height_at(profile, 0.55), 0.0);
}

TEST(DepositTest, ColumnsKeepTheAreaOfAnyParticles) {
  std::vector<double> x{0.01, 0.013};  // reach over the mirror at 0
  for (int i = 0; i < 500; ++i) x.push_back(std::pow(0.5 + 0.5 * std::sin(1.7 * i), 2));
  const Profile profile = column_profile(x, dx, 0.17);
  EXPECT_NEAR(area_between(profile, {}), static_cast<double>(x.size()) * dx * dx, 1e-10);
}

TEST(DepositTest, AParticleOverAnEdgeIsSharedByItsColumns) {
  const Profile profile = column_profile({0.18}, dx, 0.2);  // 0.13 to 0.23: 70 % and 30 %
  EXPECT_NEAR(height_at(profile, 0.1), 0.7 * dx * dx / 0.2, 1e-12);
  EXPECT_NEAR(height_at(profile, 0.3), 0.3 * dx * dx / 0.2, 1e-12);
}

TEST(DepositTest, AreaBetweenCrossingLinesCountsBothSides) {
  const Profile level{{0.0, 2.0}, {1.0, 1.0}}, falling{{0.0, 2.0}, {2.0, 0.0}};
  EXPECT_NEAR(area_between(level, falling), 1.0, 1e-12);  // two triangles of 1/2
  EXPECT_NEAR(area_between(falling, level), 1.0, 1e-12);
  EXPECT_EQ(area_between(level, level), 0.0);
}

TEST(DepositTest, AreaBeyondTheEndOfOneProfileCounts) {
  const Profile shorter{{0.5, 1.0}, {1.0, 1.0}}, longer{{0.0, 3.0}, {1.0, 1.0}};
  EXPECT_NEAR(area_between(shorter, longer), 2.0, 1e-12);
}

TEST(DepositTest, DistanceIsPerpendicular) {
  const Profile slope{{0.0, 4.0}, {3.0, 0.0}};
  EXPECT_NEAR(mean_distance({{0.0, 4.0}, {0.0, 3.0}}, slope), 12.0 / 5.0, 1e-12);
  EXPECT_TRUE(std::isnan(mean_distance({}, slope)));
}

TEST(DepositTest, TheFrontIsWhereAWedgeIsOneGrainHigh) {
  // Rows from 20 to none over 80 columns: columns of four lie on the line of the wedge.
  std::vector<int> rows;
  for (int k = 0; k < 80; ++k) rows.push_back((80 - k) / 4);
  std::vector<double> x = lattice(rows);
  const double end = 80 * dx, height = 20 * dx;
  // Whole particles: of four columns three have the depth of the line less 1/4 to 3/4 of one.
  const double off = 0.5 * dx * end / height;
  EXPECT_NEAR(closed_front(x, 2, dx, dx), end * (1.0 - dx / height), off);
  const double front = closed_front(x, 2, dx, dx);
  // A file of grains at half the density of a row goes on from it: no deposit.
  for (int k = 0; k < 40; ++k) x.push_back(end + 2.0 * dx * k);
  EXPECT_EQ(closed_front(x, 2, dx, dx), front);
  // With grains of a fifth of the size those columns would be a closed layer.
  EXPECT_GT(closed_front(x, 2, dx, 0.2 * dx), end + 70 * dx);
  EXPECT_EQ(closed_front({}, 2, dx, dx), 0.0);
}

TEST(DepositTest, TheFrontOfARoundDepositIsWhereItsRingsAreOneGrainHigh) {
  // A quarter of a cone 20 dx high and 80 dx wide, of many small shares of volume.
  std::vector<double> distances;
  const double end = 80 * dx, height = 20 * dx;
  for (int k = 0; k < 8000; ++k) {
    const double r = end * (k + 0.5) / 8000;
    const double volume =
        height * (1.0 - r / end) * 0.5 * std::numbers::pi * r * end / 8000 / (dx * dx * dx);
    for (int n = 0; n < static_cast<int>(volume + 0.5); ++n) distances.push_back(r);
  }
  // Volumes are rounded to whole particles, of which a ring at the front has 1.2 of 8000.
  EXPECT_NEAR(closed_front(distances, 3, dx, dx), end * (1.0 - dx / height), 4 * dx);
}

TEST(DepositTest, QuantileLeavesOutTheFarthestGrains) {
  std::vector<double> x;
  for (int i = 1000; i >= 0; --i) x.push_back(i);
  x.back() = 1e6;
  EXPECT_EQ(quantile(x, 0.995), 996.0);
  EXPECT_TRUE(std::isnan(quantile({}, 0.5)));
}

TEST(DepositTest, MainBodyLeavesOutLooseGrains) {
  std::vector<double> position;
  const auto put = [&](double x, double y) {
    for (const double value : {x, y, 0.0}) position.push_back(value);
  };
  put(5.0, 0.0);                                   // 0: loose, between
  for (int i = 0; i < 4; ++i) put(0.14 * i, 0.0);  // 1 to 4: a chain
  put(0.42 + 0.16, 0.0);                           // 5: just too far
  put(-0.1, -0.1);                                 // 6: across the cells' corner
  std::vector<std::size_t> body = main_body(position, 0.15);
  std::sort(body.begin(), body.end());
  const std::vector<std::size_t> expected{1, 2, 3, 4, 6};
  EXPECT_EQ(body, expected);
}

TEST(DepositTest, SoilBehindAWallIsLost) {
  const std::vector<double> position{1, 1, -9, 1, -0.9, -9, 1, -1.1, -9, -1.1, 1, -9};
  EXPECT_EQ(share_through_walls(position, 2, 1.0), 0.5);  // z does not matter in 2D
  EXPECT_EQ(share_through_walls(position, 3, 1.0), 1.0);
}

TEST(DepositTest, ProfilesSurviveTheirFile) {
  const auto path = std::filesystem::temp_directory_path() / "scarp_deposit_test.csv";
  const Profile written{{0.0, 0.25, 1.0}, {0.5, 0.125, 0.0}};
  write_profile(path, written);
  const Profile read = read_profile(path);
  EXPECT_EQ(read.x, written.x);
  EXPECT_EQ(read.height, written.height);
  std::ofstream(path) << "x,y\n1,2\nthree,4\n";
  EXPECT_THROW(read_profile(path), FileError);
  std::filesystem::remove(path);
  EXPECT_THROW(read_profile(path), FileError);
}

}  // namespace
}  // namespace scarp::validation
