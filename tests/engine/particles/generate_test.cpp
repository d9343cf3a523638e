// SPDX-License-Identifier: BSD-3-Clause
/// Counts, symmetry, order and errors of the lattice fill.
#include "engine/particles/generate.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/errors.hpp"
#include "tests/support/filled_bodies.hpp"

namespace scarp {
namespace {

using test::fill;
using test::scene_of;

std::string error_of(const Scene& scene) {
  try {
    generate_soil(scene);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

HeightField expression(const std::string& text) {
  HeightField field{{0, 0}, {10, 10}, 0.0, HeightField::Kind::expression, {}, {}, {}};
  field.expression = text;
  return field;
}

/// Whether `mirror` maps the points onto themselves; sorted by lattice cell, compared to round-off.
template <class Mirror>
void expect_mirrored(std::vector<Vec3> points, double spacing, const Mirror& mirror) {
  std::vector<Vec3> image;
  for (const Vec3& p : points) image.push_back(mirror(p));
  const auto cell = [spacing](double x) { return std::llround(4.0 * x / spacing); };
  const auto before = [&](const Vec3& a, const Vec3& b) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (cell(a[k]) != cell(b[k])) return cell(a[k]) < cell(b[k]);
    }
    return false;
  };
  std::sort(points.begin(), points.end(), before);
  std::sort(image.begin(), image.end(), before);
  for (std::size_t i = 0; i < points.size(); ++i) {
    // Coordinates below 64 m are rounded to 7e-15 m, a few times over.
    for (std::size_t k = 0; k < 3; ++k) ASSERT_NEAR(points[i][k], image[i][k], 1e-13);
  }
}

const std::vector<std::array<double, 2>> slope = {{0, 0},  {45, 0},  {45, 5},
                                                  {32, 5}, {12, 15}, {0, 15}};

TEST(GenerateSoilTest, BoxOfTenByTenMetresHoldsFortyByForty) {
  const Particles soil = fill(2, 0.25, {{.shape = Box{{0, 0, 0}, {10, 10, 0}}}});
  ASSERT_EQ(soil.position.size(), 1600U);
  for (const Vec3& p : soil.position) {
    for (std::size_t a = 0; a < 2; ++a) {
      EXPECT_EQ(std::fmod(p[a], 0.25), 0.125);
      EXPECT_GT(p[a], 0.0);
      EXPECT_LT(p[a], 10.0);
    }
    EXPECT_EQ(p[2], 0.0);
  }
}

TEST(GenerateSoilTest, FacesAtInexactMultiplesAreMet) {
  // 0.1 and 0.3 are not binary fractions: without a tolerance counts come out one off.
  const Particles soil = fill(2, 0.1, {{.shape = Box{{0.3, -0.7, 0}, {1.3, 0.3, 0}}}});
  EXPECT_EQ(soil.position.size(), 100U);
}

TEST(GenerateSoilTest, LatticeFarFromTheOriginIsComplete) {
  const double x = 4.2e6;  // an easting, where round-off is more than a billionth of the spacing
  const Particles soil = fill(2, 0.1, {{.shape = Box{{x, x, 0}, {x + 1.0, x + 2.0, 0}}}});
  EXPECT_EQ(soil.position.size(), 200U);
}

TEST(GenerateSoilTest, PointsOnAFaceCountInNearAndFarFromTheOrigin) {
  // The right face passes through a column of lattice points: 11 columns of 20, whatever the
  // rounding.
  for (const double x : {0.0, 0.3, 7.1, 4.2e6, 4.2e6 + 0.7}) {
    const double right = x + 1.05;
    const Polygon polygon{{{x, 0}, {right, 0}, {right, 2}, {x, 2}}, {}};
    EXPECT_EQ(fill(2, 0.1, {{.shape = polygon}}).position.size(), 220U) << x;
    const Box box{{x, 0, 0}, {right, 2, 0}};
    EXPECT_EQ(fill(2, 0.1, {{.shape = box}}).position.size(), 220U) << x;
  }
}

TEST(GenerateSoilTest, SlopeHoldsItsAreaExactly) {
  // Every row of the face ends on a cell boundary (42 - 2y is a multiple of 0.25 m), so the rows
  // add up to the area of 445 m2 without the half-cell error that a face has in general.
  const Particles soil = fill(2, 0.25, {{.shape = Polygon{slope}}});
  EXPECT_EQ(soil.position.size(), 7120U);
}

TEST(GenerateSoilTest, SlopeAtAnyShiftHoldsItsAreaWithinHalfACellPerRow) {
  for (const double spacing : {0.3, 0.41, 0.77}) {
    const Particles soil = fill(2, spacing, {{.shape = Polygon{slope}}});
    // Rows meet the face and the right wall, columns the crest and the toe: half a cell for each.
    const double bound = 0.5 * (15.0 + 15.0 + 45.0) / spacing + 4.0;
    EXPECT_NEAR(static_cast<double>(soil.position.size()), 445.0 / (spacing * spacing), bound);
  }
}

TEST(GenerateSoilTest, MirroredSlopeHoldsMirroredPoints) {
  auto mirrored = slope;
  for (auto& p : mirrored) p[0] = 45.0 - p[0];
  Particles both = fill(2, 0.25, {{.shape = Polygon{slope}}});
  const Particles other = fill(2, 0.25, {{.shape = Polygon{mirrored}}});
  ASSERT_EQ(both.position.size(), other.position.size());
  both.position.insert(both.position.end(), other.position.begin(), other.position.end());
  expect_mirrored(both.position, 0.25, [](const Vec3& p) { return Vec3{45.0 - p[0], p[1], 0.0}; });
}

TEST(GenerateSoilTest, FacesThroughLatticePointsAreSymmetric) {
  // Faces at 45 degrees pass exactly through lattice points; round-off must not choose a side.
  const Particles soil = fill(2, 0.1, {{.shape = Polygon{{{0, 0}, {6, 0}, {4, 2}, {2, 2}}}}});
  // Row k has 60 - 2k cells plus none lost: the points on the two faces count in.
  EXPECT_EQ(soil.position.size(), 820U);
  expect_mirrored(soil.position, 0.1, [](const Vec3& p) { return Vec3{6.0 - p[0], p[1], 0.0}; });
}

TEST(GenerateSoilTest, ConcaveOutlineLeavesItsNotchEmpty) {
  const std::vector<std::array<double, 2>> notch = {{0, 0}, {3, 0}, {3, 3}, {2, 3},
                                                    {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const Particles soil = fill(2, 0.5, {{.shape = Polygon{notch}}});
  EXPECT_EQ(soil.position.size(), 28U);
  for (const Vec3& p : soil.position) EXPECT_FALSE(p[0] > 1 && p[0] < 2 && p[1] > 1);
}

TEST(GenerateSoilTest, BoxIn3DHoldsItsVolume) {
  const Particles soil = fill(3, 0.5, {{.shape = Box{{0, 0, 0}, {2, 3, 4}}}});
  EXPECT_EQ(soil.position.size(), 4U * 6U * 8U);
}

TEST(GenerateSoilTest, ExtrudedOutlineLiesInXAndZ) {
  const Particles soil = fill(3, 0.5, {{.shape = Polygon{slope, {2.0, 4.0}}}});
  const Particles section = fill(2, 0.5, {{.shape = Polygon{slope}}});
  EXPECT_EQ(soil.position.size(), 4U * section.position.size());
  for (const Vec3& p : soil.position) {
    EXPECT_GT(p[1], 2.0);
    EXPECT_LT(p[1], 4.0);
    EXPECT_LE(p[0] + 2.0 * p[2], std::max(42.0, p[0] + 10.0) + 1e-9);
  }
}

TEST(GenerateSoilTest, DiscAndRingHoldTheirAreaAndAreSymmetric) {
  const Particles disc = fill(2, 0.1, {{.shape = Cylinder{{1, 2, 0}, 3.0, 0.0, 0.0}}});
  const Particles ring = fill(2, 0.1, {{.shape = Cylinder{{1, 2, 0}, 3.0, 2.0, 0.0}}});
  // Lattice points in a circle of R/dx = 30 differ from its area by less than 2.2 sqrt(R/dx) < 1 %.
  EXPECT_NEAR(static_cast<double>(disc.position.size()), 900.0 * std::numbers::pi, 20.0);
  EXPECT_NEAR(static_cast<double>(ring.position.size()), 500.0 * std::numbers::pi, 40.0);
  for (const Vec3& p : ring.position) {
    const double radius = std::hypot(p[0] - 1.0, p[1] - 2.0);
    EXPECT_GT(radius, 2.0 - 1e-9);
    EXPECT_LT(radius, 3.0 + 1e-9);
  }
  expect_mirrored(ring.position, 0.1, [](const Vec3& p) { return Vec3{2.0 - p[0], p[1], 0.0}; });
  expect_mirrored(ring.position, 0.1, [](const Vec3& p) {
    return Vec3{p[1] - 1.0, p[0] + 1.0, 0.0};
  });
}

TEST(GenerateSoilTest, TubeStandsUpright) {
  const Particles tube = fill(3, 0.25, {{.shape = Cylinder{{0, 0, 1}, 2.0, 1.0, 2.0}}});
  const Particles ring = fill(2, 0.25, {{.shape = Cylinder{{0, 0, 0}, 2.0, 1.0, 0.0}}});
  EXPECT_EQ(tube.position.size(), 8U * ring.position.size());
  for (const Vec3& p : tube.position) EXPECT_TRUE(p[2] > 1.0 && p[2] < 3.0);
}

TEST(GenerateSoilTest, ProfilesAlongXAndYGiveTurnedBodies) {
  HeightField field{{0, 0}, {10, 10}, -1.0, HeightField::Kind::x_profile, {}, {}, ""};
  field.profile = {{2, 3}, {6, 1}};  // constant beyond its ends
  const Particles along_x = fill(3, 0.5, {{.shape = field}});
  field.kind = HeightField::Kind::y_profile;
  const Particles along_y = fill(3, 0.5, {{.shape = field}});
  // Area of the section: 2 x 4 + 4 x 3 + 4 x 2 m2; over 4 m the face, of gradient 1/2, shifts each
  // column by at most half a cell.
  EXPECT_NEAR(static_cast<double>(along_x.position.size()), 20.0 * 28.0 / 0.25, 20.0 * 0.5 * 8.0);
  ASSERT_EQ(along_x.position.size(), along_y.position.size());
  std::vector<Vec3> both = along_x.position;
  both.insert(both.end(), along_y.position.begin(), along_y.position.end());
  expect_mirrored(both, 0.5, [](const Vec3& p) { return Vec3{p[1], p[0], p[2]}; });
}

TEST(GenerateSoilTest, RadialProfileMakesACone) {
  HeightField field{{-4, -4}, {4, 4}, 0.0, HeightField::Kind::radial_profile, {0, 0}, {}, ""};
  field.profile = {{0, 4}, {4, 0}};
  const Particles cone = fill(3, 0.2, {{.shape = field}});
  const double volume = static_cast<double>(cone.position.size()) * 0.008;
  // Each column of the plan disc errs by up to half a spacing.
  EXPECT_NEAR(volume, std::numbers::pi * 64.0 / 3.0, 0.1 * 16.0 * std::numbers::pi);
  for (const Vec3& p : cone.position) EXPECT_LE(std::hypot(p[0], p[1]) + p[2], 4.0 + 1e-9);
}

TEST(GenerateSoilTest, ExpressionEqualsTheProfileItSpells) {
  HeightField profile{{0, 0}, {10, 10}, 0.0, HeightField::Kind::x_profile, {}, {}, ""};
  profile.profile = {{0, 5}, {10, 1}};
  const Particles wanted = fill(3, 0.5, {{.shape = profile}});
  const Particles soil = fill(3, 0.5, {{.shape = expression("5 - 0.4*x")}});
  EXPECT_EQ(soil.position, wanted.position);
  // x > y has to be told from y > x.
  const Particles step = fill(3, 0.5, {{.shape = expression("x > y ? 4 : 1")}});
  for (const Vec3& p : step.position) EXPECT_TRUE(p[2] < 1.0 || p[0] > p[1]);
}

TEST(GenerateSoilTest, SharedPointsBelongToTheFirstBody) {
  const Body first{.shape = Box{{0, 0, 0}, {2, 2, 0}}, .material = "rock", .velocity = {1, 0, 0}};
  const Body second{.shape = Box{{1, 0, 0}, {4, 2, 0}}, .velocity = {0, 2, 0}};
  const Particles soil = fill(2, 0.5, {first, second});
  ASSERT_EQ(soil.position.size(), 32U);  // 16 + 24 - 8
  for (std::size_t i = 0; i < 32; ++i) {
    EXPECT_EQ(soil.material[i], soil.position[i][0] < 2.0 ? 1U : 0U);
    EXPECT_EQ(soil.velocity[i], i < 16 ? first.velocity : second.velocity);
  }
}

TEST(GenerateSoilTest, BodyInTheMiddleOfAnotherSplitsItsColumns) {
  const Body seam{.shape = Box{{0, 1, 0}, {4, 2, 0}}, .material = "rock"};
  const Body around{.shape = Box{{0, 0, 0}, {4, 4, 0}}};
  const Particles soil = fill(2, 0.5, {seam, around});
  ASSERT_EQ(soil.position.size(), 64U);
  for (std::size_t i = 0; i < 64; ++i) {
    const bool inside = soil.position[i][1] > 1.0 && soil.position[i][1] < 2.0;
    EXPECT_EQ(soil.material[i], inside ? 1U : 0U);
  }
}

TEST(GenerateSoilTest, LayersThatShareAnInclinedFaceLeaveNoGap) {
  const Body lower{.shape = Polygon{{{0, 0}, {4, 0}, {4, 4}}}};
  const Body upper{.shape = Polygon{{{0, 0}, {4, 4}, {0, 4}}}, .material = "rock"};
  EXPECT_EQ(fill(2, 0.5, {lower, upper}).position.size(), 64U);
}

TEST(GenerateSoilTest, EmptyBodyIsNamed) {
  const Body big{.shape = Box{{0, 0, 0}, {2, 2, 0}}};
  const Body small{.shape = Box{{3.3, 0.3, 0}, {3.4, 0.4, 0}}};
  const std::string message = error_of(scene_of(2, 0.5, {big, small}));
  EXPECT_NE(message.find("key 'body[1]' = box from (3.3, 0.3) to (3.4, 0.4): holds no particle at "
                         "spacing 0.5 m"),
            std::string::npos)
      << message;
}

TEST(GenerateSoilTest, BodyInsideAnEarlierOneIsNamed) {
  const Body big{.shape = Box{{0, 0, 0}, {2, 2, 0}}};
  const Body inner{.shape = Box{{0.5, 0.5, 0}, {1.5, 1.5, 0}}};
  const std::string message = error_of(scene_of(2, 0.5, {big, inner}));
  EXPECT_NE(message.find("key 'body[1]' = "), std::string::npos) << message;
  EXPECT_NE(message.find("wholly inside"), std::string::npos) << message;
}

TEST(GenerateSoilTest, WrongExpressionIsQuotedWithItsPlace) {
  const std::string message = error_of(scene_of(3, 0.5, {{.shape = expression("x + depth")}}));
  EXPECT_NE(message.find("\"x + depth\" at letter 5"), std::string::npos) << message;
  EXPECT_NE(message.find("depth"), std::string::npos) << message;
}

TEST(GenerateSoilTest, VelocityFieldIsEvaluatedAtEveryParticle) {
  Body turning{.shape = Box{{0, 0, 0}, {2, 1, 0}}};
  turning.velocity_field = {"-2*pi*y", "x^2"};
  const Particles soil = generate_soil(scene_of(2, 0.5, {turning}));
  ASSERT_EQ(soil.position.size(), 8u);
  for (std::size_t i = 0; i < soil.position.size(); ++i) {
    const Vec3& at = soil.position[i];
    EXPECT_DOUBLE_EQ(soil.velocity[i][0], -2.0 * 3.14159265358979323846 * at[1]);
    EXPECT_DOUBLE_EQ(soil.velocity[i][1], at[0] * at[0]);
  }
}

/// Rows of a material in each column along `axis`, sorted, of a seam of one row that is drawn
/// first.
std::vector<int> rows_of_seam(double seam_cohesion, const Polygon& seam, std::size_t axis) {
  Scene scene = scene_of(2, 0.5, {});
  scene.materials = {
      {"seam", DruckerPrager{1e7, 0.3, seam_cohesion, 0.2, 0.0, Cone::plane_strain}, 2000.0},
      {"rock", DruckerPrager{1e7, 0.3, 1e4, 0.5, 0.0, Cone::plane_strain}, 2000.0}};
  scene.bodies = {{.shape = seam, .material = "seam"},
                  {.shape = Box{{0, 0, 0}, {10, 10, 0}}, .material = "rock"}};
  const Particles soil = generate_soil(scene);
  EXPECT_EQ(soil.position.size(), 400u);
  std::map<double, int> rows;
  for (std::size_t k = 0; k < soil.position.size(); ++k)
    if (soil.material[k] == 0) ++rows[soil.position[k][1 - axis]];
  std::vector<int> counts;
  for (const auto& [place, count] : rows) counts.push_back(count);
  return counts;
}

TEST(GenerateSoilTest, ASingleRowOfWeakSoilTakesASecondOne) {
  const Polygon flat{{{0, 5}, {10, 5}, {10, 5.5}, {0, 5.5}}, {}},
      thick{{{0, 5}, {10, 5}, {10, 6}, {0, 6}}, {}},
      dipping{{{0, 4}, {10, 6}, {10, 6.5}, {0, 4.5}}, {}},
      steep{{{5, 0}, {5.5, 0}, {5.5, 10}, {5, 10}}, {}};
  const std::vector<int> two(20, 2), one(20, 1);
  EXPECT_EQ(rows_of_seam(0.0, flat, 1), two);
  EXPECT_EQ(rows_of_seam(0.0, thick, 1), two);
  EXPECT_EQ(rows_of_seam(0.0, dipping, 1), two);
  EXPECT_EQ(rows_of_seam(0.0, steep, 0), two);
  // Neither stronger nor weaker: less friction, more cohesion.
  EXPECT_EQ(rows_of_seam(2e4, flat, 1), one);
}

TEST(GenerateSoilTest, VelocityThatIsNotFiniteIsPlaced) {
  Body body{.shape = Box{{0, 0, 0}, {2, 1, 0}}};
  body.velocity_field = {"1/(x - 0.25)", "0"};
  EXPECT_NE(error_of(scene_of(2, 0.5, {body})).find("not finite at x = 0.25"), std::string::npos);
}

TEST(GenerateSoilTest, HeightThatIsNotFiniteIsPlaced) {
  const std::string message = error_of(scene_of(3, 0.5, {{.shape = expression("1/(x - 0.25)")}}));
  EXPECT_NE(message.find("x = 0.25, y = 0.25 is inf"), std::string::npos) << message;
  EXPECT_NE(error_of(scene_of(3, 0.5, {{.shape = expression("sqrt(-x)")}})).find("nan"),
            std::string::npos);
  EXPECT_NE(error_of(scene_of(3, 0.5, {{.shape = expression("exp(100*x)")}})).find("finite"),
            std::string::npos);
}

TEST(GenerateSoilTest, TooSmallASpacingIsRefusedBeforeMemoryIsTaken) {
  for (const double spacing : {1e-5, 1e-9}) {
    const std::string flat = error_of(scene_of(2, spacing, {{.shape = Polygon{slope}}}));
    EXPECT_NE(flat.find("particles at spacing"), std::string::npos) << flat;
    const std::string solid =
        error_of(scene_of(3, spacing, {{.shape = Box{{0, 0, 0}, {9, 9, 9}}}}));
    EXPECT_NE(solid.find("memory"), std::string::npos) << solid;
  }
}

TEST(EstimateParticlesTest, IsExactWhereColumnsAreFewAndNearWhereTheyAreMany) {
  Scene scene = scene_of(
      2, 0.25,
      {{.shape = Box{{2, 2, 0}, {6, 4, 0}}, .material = "rock"}, {.shape = Polygon{slope}}});
  scene.materials.resize(3);
  const Particles soil = generate_soil(scene);
  std::vector<double> counted(3, 0.0);
  for (const std::size_t material : soil.material) ++counted[material];
  EXPECT_EQ(estimate_particles(scene), counted);
  // 400,000 columns, and then more than any machine holds: half of width times height over dx^2.
  scene.bodies = {{.shape = Polygon{{{0, 0}, {32, 0}, {1e5, 10}, {0, 10}}}, .material = "clay"}};
  EXPECT_NEAR(estimate_particles(scene)[0], 0.5 * (1e5 + 32) * 10 / 0.0625, 1e4);
  scene.bodies = {{.shape = Box{{0, 0, 0}, {1e9, 1e9, 0}}, .material = "clay"}};
  EXPECT_NEAR(estimate_particles(scene)[0], 1.6e19, 1e15);
}

#ifndef SCARP_ADDRESS_SANITIZER  // whose own memory does not fit
// A million particles, which any machine of today holds, but not within 600 MB.
TEST(GenerateSoilTest, MoreThanUlimitLetsARunHoldAreRefused) {
  rlimit before{};
  ASSERT_EQ(getrlimit(RLIMIT_DATA, &before), 0);
  rlimit lower = before;
  lower.rlim_cur = 600'000'000;
  ASSERT_EQ(setrlimit(RLIMIT_DATA, &lower), 0);
  const std::string error =
      error_of(scene_of(2, 1.0, {{.shape = Box{{0, 0, 0}, {1000, 1000, 0}}}}));
  ASSERT_EQ(setrlimit(RLIMIT_DATA, &before), 0);
  EXPECT_NE(error.find("the 0.6 GB of memory that this process may use"), std::string::npos)
      << error;
}
#endif

}  // namespace
}  // namespace scarp
