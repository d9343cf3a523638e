// SPDX-License-Identifier: BSD-3-Clause
/// Where images stand behind smooth faces that bend, turn a convex edge, face each other, or are
/// drawn in many pieces.
#include "engine/boundary/mirror_images.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "engine/scene/facets.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

using geometry::dot;
using geometry::minus;

constexpr double dx = 0.1;
constexpr double rough_reach = 5.7 * dx;  ///< of images where rough walls stand too

using Line = std::vector<std::array<double, 2>>;

Scene scene_of(const std::vector<Line>& lines) {
  Scene scene;
  scene.spacing = dx;
  for (const Line& line : lines)
    scene.walls.push_back(wall_of("smooth", WallKind::free_slip, line_facets(line)));
  return scene;
}

/// Images of the soil, in the order in which they were made.
std::vector<Vec3> images_of(const Scene& scene, const std::vector<Vec3>& soil, double reach) {
  std::array<std::vector<double>, 3> axes;
  for (const Vec3& point : soil) {
    for (std::size_t a = 0; a < 3; ++a) axes[a].push_back(point[a]);
  }
  const WallSurface surface(scene);
  const std::vector<bool> stands(scene.walls.size(), true);
  const std::vector<Vec3> offset(scene.walls.size());
  const SlotRange range{0, static_cast<std::int64_t>(soil.size())};
  const double k0 = 0.5;
  MirrorImages images;
  images.select(1, {scene, surface, {stands, offset}, reach},
                {{axes[0].data(), axes[1].data(), axes[2].data()}, {&range, 1}, {&k0, 1}, 0}, {},
                0.0, {});
  std::vector<Vec3> places;
  for (std::int64_t g = 0; g < images.count(); ++g)
    places.push_back({images.points().x[g], images.points().y[g], images.points().z[g]});
  return places;
}

double nearest(const std::vector<Vec3>& images, const std::vector<Vec3>& soil) {
  double least = 1e300;
  for (const Vec3& image : images) {
    for (const Vec3& point : soil) {
      const Vec3 between = minus(image, point);
      least = std::min(least, std::sqrt(dot(between, between)));
    }
  }
  return least;
}

void expect_places(std::vector<Vec3> images, std::vector<Vec3> wanted) {
  const auto place = [](const Vec3& a, const Vec3& b) {
    return std::pair{std::lround(1e6 * a[0]), std::lround(1e6 * a[1])} <
           std::pair{std::lround(1e6 * b[0]), std::lround(1e6 * b[1])};
  };
  std::sort(images.begin(), images.end(), place);
  std::sort(wanted.begin(), wanted.end(), place);
  ASSERT_EQ(images.size(), wanted.size());
  for (std::size_t k = 0; k < images.size(); ++k) {
    for (std::size_t a = 0; a < 2; ++a) EXPECT_NEAR(images[k][a], wanted[k][a], 1e-12);
  }
}

/// Rows of soil along a line, the first half a spacing above it.
std::vector<Vec3> rows_above(const Line& line, int rows) {
  std::vector<Vec3> soil;
  for (const Facet& facet : line_facets(line)) {
    for (double s = 0.5 * dx; s < facet.length_u; s += dx) {
      for (int row = 0; row < rows; ++row) {
        Vec3 point{};
        for (std::size_t a = 0; a < 2; ++a)
          point[a] = facet.origin[a] + s * facet.tangent_u[a] + (row + 0.5) * dx * facet.normal[a];
        soil.push_back(point);
      }
    }
  }
  return soil;
}

/// The mirror image of a row in one piece of a bed must not have an image in the next piece: that
/// would be the row itself, turned by twice the bend. A rounding bends pieces of one line too.
TEST(ImagePlacesTest, ABedThatBendsPutsNoImageOntoItsSoil) {
  const Line beds[] = {{{0, 4}, {4, 3}, {16, 0}},     // straight but for a rounding
                       {{0, 3}, {2, 2.4}, {10, 0}},   // the same
                       {{0, 4}, {4, 3}, {16, 0.2}},   // by 0.9 deg
                       {{0, 2}, {4, 0.4}, {9, 0.4}},  // by 22 deg
                       {{0, 3}, {3, 0}, {6, 0}},      // by 45 deg
                       {{0, 0}, {3, 0}, {6, -2}}};    // convex
  for (const Line& bed : beds) {
    const std::vector<Vec3> soil = rows_above(bed, 3);
    const std::vector<Vec3> images = images_of(scene_of({bed}), soil, rough_reach);
    // A row is a spacing from its image; at a bend of 45 deg rows themselves are nearer.
    EXPECT_GT(nearest(images, soil), 0.6 * dx) << bed[1][0] << ' ' << bed[2][1];
    EXPECT_GE(images.size(), soil.size() - 6) << bed[1][0] << ' ' << bed[2][1];
  }
}

/// Soil above a smooth block and beside it: each part has images in its own face alone.
TEST(ImagePlacesTest, AConvexEdgePutsNoImageRoundTheCorner) {
  std::vector<Vec3> above, beside;
  for (double x = -0.55; x < 1.0; x += dx) {
    for (double y = -0.55; y < 0.5; y += dx) {
      if (x < 0.0 && y < 0.0) continue;
      (y > 0.0 ? above : beside).push_back({x, y, 0});
    }
  }
  std::vector<Vec3> soil = above;
  soil.insert(soil.end(), beside.begin(), beside.end());
  const Scene scene = scene_of({{{-2, 0}, {0, 0}, {0, -2}}});
  const std::vector<Vec3> images = images_of(scene, soil, rough_reach);
  ASSERT_FALSE(images.empty());
  for (const Vec3& image : images) EXPECT_TRUE(image[0] < 0.0 && image[1] < 0.0);
}

/// In a slab between two planes there are images of images to both sides.
TEST(ImagePlacesTest, ASlabHasImagesOfImagesOnBothSides) {
  const Scene scene = scene_of({{{0, 0}, {5, 0}}, {{5, dx}, {0, dx}}});
  const double y = 0.03;
  std::vector<Vec3> expected;
  // Sources within 0.3 m before a plane: mirrored there and back until they are farther.
  const auto both_ways = [&](double from, bool lower) {
    for (double at = from;; lower = !lower) {
      const double distance = lower ? at : dx - at;
      if (distance > 0.3) break;
      at = lower ? -at : 2.0 * dx - at;
      expected.push_back({2.0, at, 0});
    }
  };
  both_ways(y, true);
  both_ways(y, false);
  expect_places(images_of(scene, {{2.0, y, 0}}, 0.3), expected);
  ASSERT_GE(expected.size(), 6U);
}

/// Between three planes at right angles, in any order of the walls, each combination occurs once.
TEST(ImagePlacesTest, ASlabThatEndsAtAPlaneHasEachImageOnce) {
  std::vector<Line> lines{{{0, 0}, {5, 0}}, {{5, dx}, {0, dx}}, {{0, 1}, {0, -1}}};
  std::sort(lines.begin(), lines.end());
  do {
    const std::vector<Vec3> images = images_of(scene_of(lines), {{0.05, 0.05, 0}}, 0.3);
    std::vector<Vec3> wanted;
    for (const double y : {-0.25, -0.15, -0.05, 0.05, 0.15, 0.25, 0.35}) {
      wanted.push_back({-0.05, y, 0});
      if (y != 0.05) wanted.push_back({0.05, y, 0});
    }
    expect_places(images, wanted);
  } while (std::next_permutation(lines.begin(), lines.end()));
}

/// A floor in pieces shorter than the reach, and a side, whichever is drawn first.
TEST(ImagePlacesTest, AFloorInPiecesFillsItsCornerOnce) {
  Line floor;
  for (int k = 0; k <= 20; ++k) floor.push_back({k * 0.15, 0.0});
  const Line side{{0, 1}, {0, 0}};
  for (const bool side_first : {true, false}) {
    const Scene scene = side_first ? scene_of({side, floor}) : scene_of({floor, side});
    expect_places(images_of(scene, {{0.05, 0.05, 0}}, rough_reach),
                  {{-0.05, 0.05, 0}, {0.05, -0.05, 0}, {-0.05, -0.05, 0}});
  }
}

/// Faces that lie where another face is: one image, or none where that one is rough.
TEST(ImagePlacesTest, FacesInOnePlaceHaveOneImage) {
  const Line floor{{0, 0}, {3, 0}}, side{{0, 1}, {0, 0}}, room{{0, 1}, {0, 0}, {3, 0}, {3, 1}};
  const std::vector<Vec3> corner{{-0.05, 0.05, 0}, {0.05, -0.05, 0}, {-0.05, -0.05, 0}};
  for (const auto& lines : {std::vector<Line>{floor, side, room},
                            {floor, room},
                            {room, floor},
                            {room, side, floor},
                            {side, room, room}})
    expect_places(images_of(scene_of(lines), {{0.05, 0.05, 0}}, rough_reach), corner);
  for (const bool rough_first : {true, false}) {
    Scene scene = rough_first ? scene_of({floor, room}) : scene_of({room, floor});
    scene.walls[rough_first ? 0 : 1].kind = WallKind::no_slip;
    expect_places(images_of(scene, {{0.05, 0.05, 0}}, rough_reach), {{-0.05, 0.05, 0}});
  }
}

/// Soil that is pressed a little behind a face keeps its image there, and that of the corner.
TEST(ImagePlacesTest, SoilALittleBehindAFaceKeepsTheImageOfTheCorner) {
  const Line floor{{0, 0}, {3, 0}}, side{{0, 1}, {0, -1}};
  for (const bool side_first : {true, false}) {
    const Scene scene = side_first ? scene_of({side, floor}) : scene_of({floor, side});
    expect_places(images_of(scene, {{0.05, -0.01, 0}}, rough_reach),
                  {{-0.05, -0.01, 0}, {0.05, 0.01, 0}, {-0.05, 0.01, 0}});
  }
  // Where the side ends at the floor such soil is beyond its end, but its image in the floor is
  // not.
  expect_places(images_of(scene_of({floor, {{0, 1}, {0, 0}}}), {{0.05, -0.01, 0}}, rough_reach),
                {{0.05, 0.01, 0}, {-0.05, 0.01, 0}});
}

/// Two smooth walls back to back: what stands before one has no image in the other.
TEST(ImagePlacesTest, ImagesBehindOneFaceOfAPileHaveNoneInTheOther) {
  const Scene scene = scene_of({{{0, -3}, {0, 3}}, {{0.5, 3}, {0.5, -3}}});
  std::vector<Vec3> left;
  for (double x = -0.05; x > -0.6; x -= dx) left.push_back({x, 0, 0});
  const std::vector<Vec3> images = images_of(scene, left, 0.5);
  EXPECT_EQ(images.size(), 5U);
  for (const Vec3& image : images) EXPECT_TRUE(image[0] > 0.0 && image[0] < 0.5);
}

}  // namespace
}  // namespace scarp::test
