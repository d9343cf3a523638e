// SPDX-License-Identifier: BSD-3-Clause
/// Cracks, seams, holes, gaps and wedges that the lattice cannot show are named; what it shows is
/// not.
#include "engine/check/thin_places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "engine/scene/scene_reader.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

using Outline = std::vector<std::array<double, 2>>;

Scene plane(std::vector<Body> bodies) {
  Scene scene;
  scene.spacing = 0.1;
  scene.materials = {elastic(), clay()};
  scene.bodies = std::move(bodies);
  for (Body& body : scene.bodies) {
    if (body.material.empty()) body.material = "elastic";
  }
  return scene;
}

Body outline(Outline points, const std::string& material = "elastic") {
  return {.shape = Polygon{std::move(points)}, .material = material};
}
Body box(double x0, double y0, double x1, double y1, const std::string& material = "elastic") {
  return {.shape = Box{{x0, y0, 0}, {x1, y1, 0}}, .material = material};
}

Outline turned(Outline points, double degrees) {
  const double angle = degrees * std::atan(1.0) / 45.0;
  for (auto& [x, y] : points) {
    const double u = x * std::cos(angle) - y * std::sin(angle);
    y = x * std::sin(angle) + y * std::cos(angle);
    x = u;
  }
  return points;
}

/// A block 5 m x 3 m with a crack from the middle of its top, 1 m deep.
Outline cracked(double width) {
  return {{0, 0}, {5, 0}, {5, 3}, {2.5 + width, 3}, {2.5 + width, 2}, {2.5, 2}, {2.5, 3}, {0, 3}};
}

testing::AssertionResult names(const Scene& scene, const std::string& words) {
  const std::vector<std::string> places = thin_places(scene);
  if (places.size() == 1 && places[0].find(words) != std::string::npos)
    return testing::AssertionSuccess();
  auto result = testing::AssertionFailure();
  result << places.size() << " places instead of one with '" << words << "'";
  for (const std::string& place : places) result << "\n  " << place;
  return result;
}
testing::AssertionResult silent(const Scene& scene) {
  const std::vector<std::string> places = thin_places(scene);
  if (places.empty()) return testing::AssertionSuccess();
  return testing::AssertionFailure() << places[0];
}

TEST(ThinPlacesTest, CracksBelowTwoSpacingsAreNamedWhateverTheirDirection) {
  for (const double angle : {0.0, 20.0, 45.0, 70.0, 90.0, 135.0, 180.0}) {
    for (const double width : {0.01, 0.05, 0.1, 0.19}) {
      EXPECT_TRUE(names(plane({outline(turned(cracked(width), angle))}), "the gap at"))
          << angle << " " << width;
    }
    EXPECT_TRUE(silent(plane({outline(turned(cracked(0.21), angle))}))) << angle;
  }
  EXPECT_TRUE(silent(plane({outline(cracked(0.2))})));
}

TEST(ThinPlacesTest, TheSentenceSaysWhereHowWideAndWhichSpacing) {
  const std::vector<std::string> places = thin_places(plane({outline(cracked(0.01))}));
  ASSERT_EQ(places.size(), 1u);
  for (const char* words :
       {"in body[0]: the gap at (2.505, 2.", "is 0.01 m wide", "of 0.1 m", "Try spacing = 0.005"})
    EXPECT_NE(places[0].find(words), std::string::npos) << places[0];
}

TEST(ThinPlacesTest, LayersOfFewerThanTwoRowsAreNamed) {
  for (const double thickness : {0.02, 0.1, 0.15}) {
    const double low = 1.0, high = 1.0 + thickness;
    const std::vector<Scene> scenes{
        // A seam that a strong block covers, one between two blocks, an upright one, a slanted one.
        plane({box(0, low, 4, high, "clay"), box(0, 0, 4, 3)}),
        plane({box(0, 0, 4, low), box(0, low, 4, high, "clay"), box(0, high, 4, 3)}),
        plane({box(low, 0, high, 4, "clay"), box(0, 0, 3, 4)}),
        plane({outline(turned({{-1, low}, {5, low}, {5, high}, {-1, high}}, 30), "clay"),
               outline(turned({{0, 0}, {4, 0}, {4, 3}, {0, 3}}, 30))})};
    for (const Scene& scene : scenes)
      EXPECT_TRUE(names(scene, "material 'clay': the layer of body[")) << thickness;
  }
  EXPECT_TRUE(silent(plane({box(0, 1, 4, 1.2, "clay"), box(0, 0, 4, 3)})));
  // The same soil in two pieces is one.
  EXPECT_TRUE(silent(plane({box(0, 1, 4, 1.1), box(0, 0, 4, 3)})));
  // What an earlier body leaves of a later one.
  EXPECT_TRUE(names(plane({box(0, 0, 4, 1, "clay"), box(0, 0, 4, 1.1)}), "the layer of body[1]"));
}

TEST(ThinPlacesTest, GapsBetweenBodiesAreNamedBodiesThatTouchAreNot) {
  EXPECT_TRUE(names(plane({box(0, 0, 2, 2), box(2.05, 0, 4, 2)}), "between body[0] and body[1]"));
  EXPECT_TRUE(names(plane({box(0, 0, 2, 2), box(0, 2.15, 2, 4)}), "between body[0] and body[1]"));
  EXPECT_TRUE(silent(plane({box(0, 0, 2, 2), box(2, 0, 4, 2)})));
  EXPECT_TRUE(silent(plane({box(0, 0, 2, 2), box(2.0 + 1e-9, 0, 4, 2)})));
  EXPECT_TRUE(silent(plane({box(0, 0, 2, 2), box(1.95, 0, 4, 2)})));
  EXPECT_TRUE(silent(plane({box(0, 0, 2, 2), box(2.2, 0, 4, 2)})));
}

TEST(ThinPlacesTest, HolesAndLensesSmallerThanTwoSpacingsAreNamed) {
  const auto holed = [](double size) {
    // A hole is joined to the outline by a cut.
    const double a = 1.0, b = 1.0 + size;
    return Outline{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, a}, {a, a}, {a, b}, {b, b}, {b, a}, {0, a}};
  };
  EXPECT_TRUE(names(plane({outline(holed(0.03))}), "the hole at (1.015, 1.015)"));
  EXPECT_TRUE(names(plane({outline(holed(0.12))}), "the hole at"));
  EXPECT_TRUE(silent(plane({outline(holed(0.3))})));
  EXPECT_TRUE(names(plane({box(1, 1, 1.1, 1.1, "clay"), box(0, 0, 3, 3)}), "material 'clay'"));
}

TEST(ThinPlacesTest, NaturalTapersAreNotNamedFlatWedgesAre) {
  const auto wedge = [](double degrees) {
    return Outline{{0, 0}, {10, 0}, {0, 10 * std::tan(degrees * std::atan(1.0) / 45.0)}};
  };
  for (const double degrees : {15.0, 26.6, 45.0, 75.0})
    EXPECT_TRUE(silent(plane({outline(wedge(degrees))}))) << degrees;
  for (const double degrees : {2.0, 5.0})
    EXPECT_TRUE(names(plane({outline(wedge(degrees))}), "thins out to nothing over")) << degrees;
  // A notch that narrows to its foot: wide like a valley, or a crack.
  const auto notch = [](double width) {
    return Outline{{0, 0}, {5, 0}, {5, 3}, {2.5 + 0.5 * width, 3}, {2.5, 1}, {2.5 - 0.5 * width, 3},
                   {0, 3}};
  };
  EXPECT_TRUE(silent(plane({outline(notch(1.0))})));
  EXPECT_TRUE(names(plane({outline(notch(0.1))}), "the gap at"));
  EXPECT_TRUE(silent(plane({{.shape = Cylinder{{0, 0, 0}, 1.0}}})));
  EXPECT_TRUE(names(plane({{.shape = Cylinder{{0, 0, 0}, 1.0, 0.85}}}), "the layer of body[0]"));
}

TEST(ThinPlacesTest, CornersOfTurnedBodiesAreNoLayers) {
  const Outline block{{0, 0}, {3, 0}, {3, 2}, {0, 2}},
      slope{{0, 0}, {8, 0}, {3, 2.5}, {0, 2.5}};  // its toe of 26.6 degrees is a natural one
  // A seam of one row, and a tip of 5 degrees, are named however they are turned.
  const Outline seam{{0, 0}, {3, 0}, {3, 0.1}, {0, 0.1}}, tip{{0, 0}, {9, 0}, {0, 0.787}};
  for (double angle = 0.0; angle < 180.0; angle += 1.0) {
    EXPECT_TRUE(silent(plane({outline(turned(block, angle))}))) << angle;
    EXPECT_TRUE(silent(plane({outline(turned(slope, angle))}))) << angle;
    EXPECT_TRUE(names(plane({outline(turned(seam, angle))}), "the layer of body[0]")) << angle;
    EXPECT_FALSE(silent(plane({outline(turned(tip, angle))}))) << angle;
  }
  const auto solid = [](const Outline& points) {
    Scene scene = plane({{.shape = Polygon{points, {0.0, 1.0}}}});
    scene.dimension = 3;
    scene.gravity = {0, 0, -9.81};
    return scene;
  };
  for (double angle = 0.0; angle < 180.0; angle += 7.5) {
    EXPECT_TRUE(silent(solid(turned(block, angle)))) << angle;
    EXPECT_TRUE(silent(solid(turned(slope, angle)))) << angle;
    EXPECT_TRUE(names(solid(turned(seam, angle)), "the layer of body[0]")) << angle;
    EXPECT_FALSE(silent(solid(turned(tip, angle)))) << angle;
  }
}

TEST(ThinPlacesTest, ThreeDimensionsAreCutAlongEveryAxis) {
  const auto solid = [](std::vector<Body> bodies) {
    Scene scene = plane(std::move(bodies));
    scene.dimension = 3;
    scene.gravity = {0, 0, -9.81};
    return scene;
  };
  const Body block{.shape = Box{{0, 0, 0}, {1, 1, 1}}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Box beside{{0, 0, 0}, {1, 1, 1}};
    beside.minimum[axis] = 1.05;
    beside.maximum[axis] = 2.0;
    EXPECT_TRUE(names(solid({block, {.shape = beside}}), "between body[0] and body[1]")) << axis;
  }
  EXPECT_TRUE(silent(solid({block})));
  EXPECT_TRUE(names(solid({{.shape = Polygon{cracked(0.05), {0.0, 1.0}}}}), "the gap at"));
  EXPECT_TRUE(
      names(solid({{.shape = Cylinder{{0, 0, 0}, 1.0, 0.9, 1.0}}}), "the layer of body[0]"));
  EXPECT_TRUE(silent(solid({{.shape = Cylinder{{0, 0, 0}, 1.0, 0.0, 1.0}}})));
  HeightField cover{{0, 0}, {2, 2}, 1.0, HeightField::Kind::expression, {}, {}, "1.1 + 0.01*x"};
  const Body rock{.shape = Box{{0, 0, 0}, {2, 2, 1}}};
  EXPECT_TRUE(names(solid({rock, {.shape = cover, .material = "clay"}}),
                    "material 'clay': the layer of body[1]"));
  cover.expression = "1.5 + 0.5*x";
  EXPECT_TRUE(silent(solid({rock, {.shape = cover, .material = "clay"}})));
}

TEST(ThinPlacesTest, ScenesOfTheValidationHaveNone) {
  std::size_t scenes = 0;
  const std::filesystem::path cases = std::filesystem::path(SCARP_SOURCE_DIR) / "validation/cases";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(cases)) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    EXPECT_TRUE(silent(read_scene(entry.path().string(), {}))) << entry.path();
  }
  EXPECT_GT(scenes, 15u);
}

TEST(ThinPlacesTest, HugeScenesAndOutlinesAreLookedAtAlongFewerLines) {
  EXPECT_TRUE(names(plane({outline({{0, 0}, {32, 0}, {1e8, 10}, {0, 10}})}), "body[0]"));
  Outline comb{{0, 0}};
  for (int k = 0; k < 5000; ++k) {
    comb.push_back({static_cast<double>(k), 3.0});
    comb.push_back({k + 0.5, 3.3});
  }
  comb.push_back({5000, 0});
  EXPECT_TRUE(silent(plane({outline(comb)})));
}

}  // namespace
}  // namespace scarp::test
