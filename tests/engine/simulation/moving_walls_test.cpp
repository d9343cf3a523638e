// SPDX-License-Identifier: BSD-3-Clause
/// Walls that move: against closed forms, and against walls at rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr const char* presets[]{"paper", "modern"};
/// Places of some metres round by 4e-16 m at every step; 150 steps, in which sound carries that on
/// and does not let it grow, make 6e-14 m at most.
constexpr double round_off = 1e-13;
/// Of the stress: that over a spacing, at the stiffness of the soil, 13.5 MPa and less.
constexpr double stress_round_off = 13.5e6 * round_off / 0.1;

/// The whole scene, soil and walls, at a speed of its own besides.
Scene carried(Scene scene, const Vec3& speed) {
  for (Body& body : scene.bodies) {
    for (std::size_t a = 0; a < 3; ++a) body.velocity[a] += speed[a];
  }
  for (Wall& wall : scene.walls) {
    for (std::size_t a = 0; a < 3; ++a) wall.velocity[a] += speed[a];
  }
  return scene;
}

/// Steps both and looks at the largest differences of places [m], as seen from the walls, and of
/// stresses [Pa]. Damping acts on the speed itself: there must be none.
struct Difference {
  double place = 0.0, stress = 0.0;
};
Difference difference(const Scene& scene, const Vec3& speed, int steps) {
  Simulation rests(scene, {1, {}}), moves(carried(scene, speed), {1, {}});
  Difference most;
  for (int k = 0; k < steps; ++k) {
    rests.step();
    moves.step();
    const double time = moves.last_step().time;
    EXPECT_NEAR(time, rests.last_step().time, round_off);
    const auto x = rests.field("position"), y = moves.field("position");
    const auto s = rests.field("stress"), t = moves.field("stress");
    for (std::size_t i = 0; i < x.size(); ++i)
      most.place = std::max(most.place, std::abs(y[i] - speed[i % 3] * time - x[i]));
    for (std::size_t i = 0; i < s.size(); ++i)
      most.stress = std::max(most.stress, std::abs(t[i] - s[i]));
  }
  EXPECT_EQ(moves.face_hold_count(), rests.face_hold_count());
  return most;
}

/// Physics does not know who moves: a floor that comes up to a grain throws it back as a floor does
/// that the grain falls on.
TEST(MovingWallTest, AGrainIsHeldOffAsByAFloorAtRest) {
  for (const char* name : presets) {
    Scene scene = elastic_column(name, 1.0, 0.1);
    scene.materials = {
        {"sand", DruckerPrager{1e4, 0.3, 0.0, 0.52, 0.0, Cone::plane_strain}, 2000.0}};
    scene.bodies = {{.shape = Box{{0, 0.2, 0}, {0.1, 0.3, 0}}, .velocity = {1.0, -1.0, 0.0}}};
    scene.walls = {wall_of("floor", WallKind::no_slip, {facet_2d(-10, 0, 10, 0)})};
    scene.stages = {stage_for("fall", 10.0)};
    constexpr int steps = 30;  // it meets the floor and leaves it
    ASSERT_GT(run_steps(scene, steps, {1, {}}).face_hold_count(), 0U) << name;
    const Difference found = difference(scene, {-0.7, 1.5, 0.0}, steps);
    EXPECT_LT(found.place, round_off) << name;
    EXPECT_LT(found.stress, stress_round_off) << name;
  }
}

/// A bed between smooth sides on a rough base that is thrown about inside: images and dummies.
TEST(MovingWallTest, ABoxOfSoilMovesAsOneAtRest) {
  for (const char* name : presets) {
    Scene scene = elastic_column(name, 1.0, 0.1);
    scene.walls = {
        wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 1, 0)}),
        wall_of("sides", WallKind::free_slip, {facet_2d(1, 0, 1, 2), facet_2d(0, 2, 0, 0)})};
    scene.bodies[0].velocity = {0.3, -0.5, 0.0};
    scene.stages = {stage_for("shake", 10.0)};
    const Difference found = difference(scene, {0.7, 2.0, 0.0}, 150);
    EXPECT_LT(found.place, round_off) << name;
    EXPECT_LT(found.stress, stress_round_off) << name;
  }
}

TEST(MovingWallTest, PistonCompressesTheColumnByItsStroke) {
  Scene scene = elastic_column("modern", 1.0, 0.1);
  scene.gravity = {};
  scene.walls.push_back(wall_of("piston", WallKind::free_slip, {facet_2d(1, 1, 0, 1)}));
  scene.walls[1].velocity = {0, -0.02, 0};
  Stage push = stage_for("push", 0.25);
  push.damping = 20.0;
  scene.stages = {push};
  Simulation simulation(scene, {1, {}});
  while (!simulation.finished()) simulation.step();
  const auto stress = simulation.field("stress");
  double mean = 0.0;
  for (std::size_t k = 1; k < stress.size(); k += 6)
    mean += stress[k] * 6.0 / static_cast<double>(stress.size());
  const double modulus = 10e6 * 0.7 / (1.3 * 0.4);
  // ln(1 - 0.005) of strain. The first wave carries rho c v = 3.3 kPa of 67 and has decayed by
  // exp(-2.5); the damping takes rho L c_d v/2 = 0.4 kPa between piston and base: 2 % and 3 %.
  EXPECT_NEAR(mean / (modulus * std::log(1 - 0.005)), 1.0, 0.02);
  EXPECT_NEAR(simulation.wall_reactions()[1].force[1] / -mean, 1.0, 0.03);
}

/// The margin of the neighbour lists says when they are built, and nothing else: a piston drives
/// soil that is thrown against it.
TEST(MovingWallTest, MarginsOfListsChangeNothing) {
  const auto places = [](WallKind kind, double skin, int steps) {
    Scene scene = elastic_column("modern", 1.0, 0.1);
    scene.gravity = {};
    scene.numerics.skin = skin;
    scene.walls.push_back(wall_of("piston", kind, {facet_2d(1, 1.3, 0, 1.3)}));
    scene.walls[1].velocity = {0, -8.0, 0};
    scene.bodies[0].velocity = {0.0, 5.0, 0.0};
    scene.stages = {stage_for("meet", 10.0)};
    const Simulation simulation = run_steps(scene, steps, {1, {}});
    return std::pair{simulation.field("position"), simulation.rebuild_count()};
  };
  constexpr int steps = 60;
  for (const WallKind kind : {WallKind::no_slip, WallKind::free_slip}) {  // images go twice its way
    const auto [often, many] = places(kind, 0.02, steps);
    const auto [seldom, few] = places(kind, 0.5, steps);
    EXPECT_GT(many, 2 * few);
    EXPECT_GT(few, 1u);
    // Images are reflected sums: some roundings more.
    const double few_roundings = kind == WallKind::no_slip ? round_off : 4.0 * round_off;
    for (std::size_t k = 0; k < often.size(); ++k) EXPECT_NEAR(often[k], seldom[k], few_roundings);
  }
}

/// A gate that is lifted and then removed: its way no longer wears out the lists.
TEST(MovingWallTest, AWallThatHasGoneNoLongerMoves) {
  Scene scene = elastic_column("modern", 1.0, 0.1);
  scene.walls.push_back(wall_of("gate", WallKind::free_slip, {facet_2d(1, 5, 0, 5)}));
  scene.walls[1].velocity = {0, 20.0, 0};
  scene.walls[1].removed_at = "rest";
  Stage rest = stage_for("rest", 10.0);
  rest.damping = 15.0;
  scene.stages = {stage_for("lift", 0.05), rest};
  Simulation simulation(scene, {1, {}});
  while (simulation.stage_index() == 0) simulation.step();
  EXPECT_GT(simulation.rebuild_count(), 20u);
  const auto before = simulation.rebuild_count();
  for (int k = 0; k < 50; ++k) simulation.step();
  EXPECT_LE(simulation.rebuild_count(), before + 3);
}

}  // namespace
}  // namespace scarp::test
