// SPDX-License-Identifier: BSD-3-Clause
/// Walls of any two kinds that meet, end, overlap, cross and move past each other hold the soil.
#include "tests/engine/boundary/wall_meetings.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

namespace scarp::test {
namespace {

/// How much further than between walls that meet exactly a grain may move [spacings]: the seams of
/// the dummies' layers are up to half a spacing wide, and so are the places the soil sinks into.
/// Sides that stand off the lattice leave their offset besides.
double slack(const Meeting& m) { return 0.5 + m.offset; }

void expect_holds(const std::vector<Meeting>& meetings, std::size_t first, std::size_t stride) {
  std::map<std::string, Outcome> references;
  for (std::size_t k = first; k < meetings.size(); k += stride) {
    const Meeting& m = meetings[k];
    const Meeting plain = exact(m);
    const auto [reference, is_new] = references.try_emplace(describe(plain));
    if (is_new) reference->second = run_basin(plain);
    const Outcome outcome = run_basin(m);
    EXPECT_EQ(outcome.lost, 0) << describe(m);
    EXPECT_EQ(outcome.stopped, "") << describe(m);
    EXPECT_TRUE(m.plate || m.left_moves != 0.0 || outcome.rested) << describe(m);
    EXPECT_LE(outcome.displacement, reference->second.displacement + slack(m)) << describe(m);
  }
}

/// Every seventeenth; with SCARP_EVERY_MEETING, as under the label `faults`, every one.
TEST(WallMeetingsTest, HoldTheSoil) {
  expect_holds(all_meetings(), 0, std::getenv("SCARP_EVERY_MEETING") != nullptr ? 1 : 17);
}

/// A box of soil on a base between four sides; rectangles in three directions meet in its corners.
struct Room {
  WallKind base = WallKind::no_slip, along_x = WallKind::no_slip, along_y = WallKind::no_slip;
  double base_beyond = 0.0, sides_beyond = 0.0;  ///< [spacings]
  bool sand = false;
};

std::string describe(const Room& r) {
  return std::string(r.sand ? "sand" : "clay") + ", base " + kind_name(r.base) + ", sides " +
         kind_name(r.along_x) + " and " + kind_name(r.along_y) + ", beyond " +
         std::to_string(r.base_beyond) + " and " + std::to_string(r.sides_beyond);
}

Scene room_scene(const Room& r) {
  const double dx = 0.1, x = 0.4, y = 0.3, h = 0.4;
  const double out = r.base_beyond * dx, below = r.sides_beyond * dx;
  Scene scene;
  scene.dimension = 3;
  scene.gravity = {0, 0, -9.81};
  scene.spacing = dx;
  scene.numerics = preset("modern");
  scene.materials = {
      {"soil",
       DruckerPrager{2e6, 0.3, r.sand ? 0.0 : 1e3, r.sand ? 0.576 : 0.349, 0.0, Cone::plane_strain},
       2000.0}};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {x, y, h}}}};
  const double tall = 2.0 * h + below;
  const Vec3 ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};
  scene.walls = {
      wall_of("base", r.base, {{{-out, -out, 0}, ex, ey, x + 2 * out, y + 2 * out, {0, 0, 1}}}),
      wall_of("x", r.along_x,
              {{{0, -out, -below}, ey, ez, y + 2 * out, tall, {1, 0, 0}},
               {{x, -out, -below}, ez, ey, tall, y + 2 * out, {-1, 0, 0}}}),
      wall_of("y", r.along_y,
              {{{-out, 0, -below}, ez, ex, tall, x + 2 * out, {0, 1, 0}},
               {{-out, y, -below}, ex, ez, x + 2 * out, tall, {0, -1, 0}}})};
  scene.initial_stress = InitialStress::geostatic;
  Stage settle = stage_for("settle", 2.0);
  settle.until = StageEnd::rest;
  settle.damping = 60.0;
  scene.stages = {settle};
  return scene;
}

TEST(WallMeetingsTest, CornersOfThreeRectanglesHoldTheSoil) {
  constexpr WallKind kinds[] = {WallKind::no_slip, WallKind::free_slip};
  std::vector<Room> rooms;
  for (const WallKind base : kinds) {
    for (const WallKind x : kinds) {
      for (const WallKind y : kinds) {
        for (const auto& [out, below] : {std::pair{0.0, 0.0},
                                         {0.0, 3.0},
                                         {3.0, 0.0},
                                         {0.5, 0.5},
                                         {3.0, 3.0},
                                         {-0.5, 0.0},
                                         {0.0, -0.9}}) {
          rooms.push_back({base, x, y, out, below, rooms.size() % 2 == 0});
        }
      }
    }
  }
  RunOptions options;
  options.threads = 1;
  for (const Room& room : rooms) {
    Simulation simulation(room_scene(room), options);
    while (!simulation.finished()) ASSERT_NO_THROW(simulation.step()) << describe(room);
    EXPECT_TRUE(simulation.stage_reached_rest()) << describe(room);
    const std::vector<double> at = simulation.field("position"),
                              moved = simulation.field("displacement");
    for (std::size_t k = 0; k < simulation.soil_count(); ++k) {
      const double* p = &at[3 * k];
      const double deepest = std::max({-p[0], p[0] - 0.4, -p[1], p[1] - 0.3, -p[2]});
      ASSERT_LE(deepest, 0.05) << describe(room);
      // Walls that meet exactly leave it where it was within 2 % of a spacing; seams as above.
      EXPECT_LE(std::hypot(moved[3 * k], moved[3 * k + 1], moved[3 * k + 2]), 0.052)
          << describe(room);
    }
  }
}

/// Soft clay in a smooth box on a rough base; the sides are drawn 1 m deeper than the base.
TEST(WallMeetingsTest, BedBetweenSidesThatGoOnBelowStaysAtRest) {
  Scene scene;
  scene.spacing = 0.1;
  scene.numerics = preset("modern");
  scene.materials = {
      {"clay", DruckerPrager{2e6, 0.3, 1e3, 0.349, 0.0, Cone::plane_strain}, 2000.0}};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {1, 2, 0}}}};
  scene.walls = {
      wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 1, 0)}),
      wall_of("sides", WallKind::free_slip, {facet_2d(0, 4, 0, -1), facet_2d(1, -1, 1, 4)})};
  scene.initial_stress = InitialStress::geostatic;
  Stage settle = stage_for("settle", 5.0);
  settle.until = StageEnd::rest;
  scene.stages = {settle};
  scene.stages[0].reset_after = true;
  Simulation deep(scene);
  while (!deep.finished()) deep.step();
  scene.walls[1].facets = {facet_2d(0, 4, 0, 0), facet_2d(1, 0, 1, 4)};
  Simulation level(scene);
  while (!level.finished()) level.step();
  EXPECT_TRUE(deep.stage_reached_rest());
  // Nothing tells the two apart: the same dummies, the same images.
  EXPECT_EQ(deep.field("position"), level.field("position"));
}

/// An oedometer: a rough plate presses clay without weight in a smooth box by a fifth.
TEST(WallMeetingsTest, RoughPlateBetweenSmoothSidesKeepsAllSoilBelowIt) {
  Scene scene;
  scene.spacing = 0.05;
  scene.gravity = {};
  scene.numerics = preset("modern");
  scene.materials = {
      {"clay", DruckerPrager{2e6, 0.3, 10e3, 0.349, 0.0, Cone::plane_strain}, 1800.0}};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {1, 0.5, 0}}}};
  Wall plate = wall_of("plate", WallKind::no_slip, {facet_2d(1, 0.5, 0, 0.5)});
  plate.velocity = {0.0, -0.1, 0.0};
  scene.walls = {
      wall_of("sides", WallKind::free_slip, {facet_2d(0, 1, 0, 0), facet_2d(1, 0, 1, 1)}),
      wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 1, 0)}), plate};
  scene.stages = {stage_for("press", 1.0)};
  Simulation simulation(scene);
  while (!simulation.finished()) ASSERT_NO_THROW(simulation.step());
  const std::vector<double> at = simulation.field("position");
  for (std::size_t k = 0; k < simulation.soil_count(); ++k) {
    EXPECT_LT(at[3 * k + 1], 0.4);
    EXPECT_TRUE(at[3 * k] > 0.0 && at[3 * k] < 1.0);
  }
}

/// Half a footing beside its symmetry plane is half of the whole, and nothing squeezes past its end
/// there.
TEST(WallMeetingsTest, FootingBesideASymmetryPlaneIsHalfOfTheWhole) {
  const auto footing = [](double left) {
    Scene scene;
    scene.spacing = 0.1;
    scene.numerics = preset("modern");
    scene.materials = {
        {"clay", DruckerPrager{2e6, 0.3, 5e3, 0.349, 0.0, Cone::plane_strain}, 2000.0}};
    scene.bodies = {{.shape = Box{{left, 0, 0}, {2, 1, 0}}}};
    const double reach = left < 0.0 ? -0.5 : 0.0;
    Wall plate = wall_of("footing", WallKind::no_slip, {facet_2d(0.5, 1, reach, 1)});
    plate.velocity = {0.0, -0.1, 0.0};
    scene.walls = {
        wall_of("base", WallKind::no_slip, {facet_2d(left, 0, 2, 0)}),
        wall_of("sides", WallKind::free_slip, {facet_2d(left, 2, left, 0), facet_2d(2, 0, 2, 2)}),
        plate};
    scene.initial_stress = InitialStress::geostatic;
    scene.stages = {stage_for("press", 1.0)};
    return scene;
  };
  Simulation half(footing(0.0)), whole(footing(-2.0));
  while (!half.finished()) ASSERT_NO_THROW(half.step());
  while (!whole.finished()) ASSERT_NO_THROW(whole.step());
  const std::vector<double> at = half.field("position");
  for (std::size_t k = 0; k < half.soil_count(); ++k) {
    EXPECT_TRUE(at[3 * k + 1] < 0.9 || at[3 * k] > 0.5);
    EXPECT_GT(at[3 * k], 0.0);
  }
  const double force = half.wall_reactions()[2].force[1];
  // The plane is exact; what differs is where the dummies of the footing average over, and time.
  EXPECT_NEAR(2.0 * force, whole.wall_reactions()[2].force[1], 0.02 * std::abs(2.0 * force));
}

/// A smooth wall that goes takes its corner's dummies along; going on from a snapshot keeps them.
TEST(WallMeetingsTest, CornersOfWallsThatMoveAndGoSurviveASnapshot) {
  Meeting m;
  m.left = WallKind::free_slip;
  m.right = WallKind::free_slip;
  m.plate = true;
  Scene scene = basin(m);
  scene.stages.push_back(stage_for("release", 0.05));
  scene.walls[1].removed_at = "release";
  RunOptions options;
  options.threads = 1;
  Simulation straight(scene, options);
  for (int k = 0; k < 40; ++k) straight.step();
  Simulation resumed(scene, straight.snapshot(), options);
  while (!straight.finished()) straight.step();
  while (!resumed.finished()) resumed.step();
  EXPECT_EQ(straight.field("position"), resumed.field("position"));
  options.threads = 2;
  Simulation other(scene, options);
  while (!other.finished()) other.step();
  EXPECT_EQ(straight.field("position"), other.field("position"));
}

}  // namespace
}  // namespace scarp::test
