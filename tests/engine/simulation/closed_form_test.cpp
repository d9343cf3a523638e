// SPDX-License-Identifier: BSD-3-Clause
/// Whole runs against closed forms, conservation and symmetry.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/scene/facets.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// Settlement of the top particle of a column of height H under its weight: gamma/M (H y - y^2/2).
double settlement(double height, double y) {
  const double youngs = 10e6, poisson = 0.3;
  const double modulus = youngs * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
  return 2000.0 * 9.81 / modulus * (height * y - 0.5 * y * y);
}

double top_settlement(Simulation& simulation, double height, double spacing) {
  while (!simulation.finished()) simulation.step();
  const auto displacement = simulation.field("displacement");
  double lowest = 0.0;
  for (std::size_t k = 1; k < displacement.size(); k += 3)
    lowest = std::min(lowest, displacement[k]);
  return -lowest / settlement(height, height - 0.5 * spacing);
}

TEST(ElasticColumnTest, ModernSettlesAsTheClosedForm) {
  for (const Integrator integrator : {Integrator::verlet, Integrator::kick_drift_kick}) {
    Scene scene = elastic_column("modern", 2.0, 0.125);
    scene.numerics.integrator = integrator;
    if (integrator == Integrator::verlet) scene.numerics.cfl = 0.3;  // its limit is lower: it leaps
    Simulation simulation(scene, {1, {}});
    // 1 %: the band of the oedometer case; the lattice moment is divided out, finite strain is 0.1
    // %.
    EXPECT_NEAR(top_settlement(simulation, 2.0, 0.125), 1.0, 0.01);
    EXPECT_TRUE(simulation.stage_reached_rest());
  }
}

TEST(ElasticColumnTest, PaperSettlesByTheLatticeMomentSquaredMore) {
  Simulation simulation(elastic_column("paper", 2.0, 0.125), {1, {}});
  const double expected = 1.0 / (simulation.lattice_moment() * simulation.lattice_moment());
  EXPECT_NEAR(simulation.lattice_moment(), 0.9452,
              5e-5);  // table of numerics: Yang & Liu, h/dx 1.2
  // 1.5 %: the oedometer's band; the base and the top have one-sided supports.
  EXPECT_NEAR(top_settlement(simulation, 2.0, 0.125), expected, 0.015 * expected);
}

TEST(ElasticColumnTest, BaseCarriesTheWeight) {
  Simulation simulation(elastic_column("modern", 2.0, 0.125), {1, {}});
  while (!simulation.finished()) simulation.step();
  const double weight = 2000.0 * 9.81 * 2.0;
  const WallReaction reaction = simulation.wall_reactions().front();
  // At rest to 1e-6 m/s with damping 15/s the remaining forces are below 1e-5 of the weight.
  EXPECT_NEAR(reaction.force[1], -weight, 1e-4 * weight);
  EXPECT_NEAR(reaction.force[0], 0.0, 1e-4 * weight);
}

TEST(ElasticColumnTest, CeilingCarriesTheWeightInTension) {
  Scene scene = elastic_column("paper", 1.0, 0.125);
  ASSERT_GT(scene.numerics.artificial_stress, 0.0);
  scene.gravity = {0.0, 9.81, 0.0};  // hangs from its base
  scene.initial_stress = InitialStress::zero;
  Simulation simulation(scene, {1, {}});
  while (!simulation.finished()) simulation.step();
  const double weight = 2000.0 * 9.81 * 1.0;
  // As above; the artificial stress carries a part of it.
  EXPECT_NEAR(simulation.wall_reactions().front().force[1], weight, 1e-4 * weight);
}

TEST(FreeBlockTest, ConservesMomentum) {
  for (const char* name : {"paper", "modern"}) {
    Scene scene = elastic_column(name, 1.0, 0.1);
    scene.walls.clear();
    scene.gravity = {};
    scene.bodies[0].velocity = {1.0, -2.0, 0.0};
    scene.stages = {stage_for("fly", 10.0)};
    scene.initial_stress = InitialStress::zero;
    Simulation simulation = run_steps(scene, 200);
    Vec3 mean{};
    const auto velocity = simulation.field("velocity");
    for (std::size_t k = 0; k < velocity.size(); ++k) mean[k % 3] += velocity[k];
    const auto count = static_cast<double>(simulation.soil_count());
    // Round-off of 200 steps of sums over 20 neighbours.
    EXPECT_NEAR(mean[0] / count, 1.0, 1e-11);
    EXPECT_NEAR(mean[1] / count, -2.0, 1e-11);
  }
}

/// A strong block on a weak seam (c = 0, phi = 10 deg) slides down a plane of 14.7 deg with
/// g (sin b - sin phi cos b): without dilation a slip plane mobilises tan phi' = sin phi (Davis
/// 1968).
TEST(SeamTest, ABlockSlidesOnASeamOfOneAndOfTwoRows) {
  const double dx = 0.25, phi = 10.0 * std::numbers::pi / 180.0;
  for (const double rows : {1.0, 2.0}) {
    Scene scene;
    scene.spacing = dx;
    scene.gravity = {2.5, -9.5, 0.0};
    scene.materials = {
        {"seam", DruckerPrager{16e6, 0.3, 0.0, phi, 0.0, Cone::plane_strain}, 2000.0},
        {"rock", DruckerPrager{16e6, 0.3, 1e5, 0.5, 0.0, Cone::plane_strain}, 2000.0}};
    scene.bodies = {{.shape = Box{{0, 2, 0}, {10, 2 + rows * dx, 0}}, .material = "seam"},
                    {.shape = Box{{0, 0, 0}, {10, 4.25, 0}}, .material = "rock"}};
    scene.walls = {wall_of("base", WallKind::no_slip, {facet_2d(-1, 0, 12, 0)})};
    scene.initial_stress = InitialStress::geostatic;
    scene.stages = {stage_for("slide", 1.0)};
    Simulation simulation(scene, {1, {}});
    while (!simulation.finished()) simulation.step();
    const std::vector<double> position = simulation.field("position"),
                              velocity = simulation.field("velocity");
    double sum = 0.0, count = 0.0;
    for (std::size_t k = 0; k < position.size(); k += 3) {
      if (position[k + 1] < 3.0) continue;
      sum += velocity[k];
      ++count;
    }
    const double rigid = 2.5 - std::sin(phi) * 9.5;
    // Two rows, dx/L = 2.5 % of the length, slip without rock above them at one end. One row is
    // made two by the row above it.
    EXPECT_NEAR(sum / count / rigid, 1.0, 0.03) << rows;
  }
}

TEST(MirrorTest, HalfABodyBehindAFreeSlipPlaneMovesAsTheWhole) {
  const auto scene_of = [](double left, bool mirrored) {
    Scene scene = elastic_column("modern", 1.0, 0.1);
    scene.bodies = {{.shape = Box{{left, 0, 0}, {1, 1, 0}}}};
    scene.walls = {wall_of("base", WallKind::no_slip, {facet_2d(-2, 0, 2, 0)})};
    if (mirrored)
      scene.walls.push_back(wall_of("plane", WallKind::free_slip, {facet_2d(0, 2, 0, 0)}));
    scene.stages = {stage_for("fall", 10.0)};
    return scene;
  };
  Simulation whole = run_steps(scene_of(-1, false), 150), half = run_steps(scene_of(0, true), 150);
  const auto everywhere = whole.field("position"), right = half.field("position");
  // Dummies near the plane see images of the soil, but their own grid ends differently: 1e-9 of 1 m
  // is round-off after 150 steps of a stiff body.
  for (std::size_t i = 0; i < right.size(); i += 3) {
    double nearest = 1.0;
    for (std::size_t j = 0; j < everywhere.size(); j += 3) {
      nearest =
          std::min(nearest, std::hypot(right[i] - everywhere[j], right[i + 1] - everywhere[j + 1]));
    }
    EXPECT_LT(nearest, 1e-9);
  }
}

/// A box of smooth sides that forgot to leave out its lower face, on a rough base: as without it.
TEST(MirrorTest, ARoughFaceDecidesWhereASmoothOneLiesToo) {
  const auto column = [](bool forgot) {
    Scene scene = elastic_column("modern", 1.0, 0.1);
    scene.walls = {
        wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 1, 0)}),
        wall_of("sides", WallKind::free_slip, {facet_2d(0, 2, 0, 0), facet_2d(1, 0, 1, 2)})};
    if (forgot) scene.walls[1].facets.push_back(facet_2d(0, 0, 1, 0));
    scene.bodies[0].velocity = {0.3, -0.1, 0};
    return run_steps(scene, 100).field("position");
  };
  EXPECT_EQ(column(true), column(false));
}

/// Between two smooth planes a spacing apart every row of images is the soil itself: plane strain,
/// as in a slab of four spacings.
TEST(MirrorTest, ASlabOneSpacingWideIsAWideOne) {
  const auto slab = [](int rows) {
    Scene scene = elastic_column("modern", 1.0, 0.1);
    scene.dimension = 3;
    scene.gravity = {0.0, 0.0, -9.81};
    const double width = 0.1 * rows;
    scene.bodies = {{.shape = Box{{0, 0, 0}, {1, width, 1}}}};
    scene.walls = {
        wall_of("room", WallKind::free_slip,
                box_facets({{0, 0, 0}, {1, width, 2}}, {"-z", "+z", "+x"}, 3)),
        wall_of("base", WallKind::no_slip,
                box_facets({{-1, 0, 0}, {3, width, 2}}, {"-x", "+x", "-y", "+y", "+z"}, 3))};
    scene.stages = {stage_for("spread", 10.0)};
    return run_steps(scene, 100);
  };
  const auto thin = slab(1).field("position"), wide = slab(4).field("position");
  for (std::size_t i = 0; i < thin.size(); i += 3) {
    EXPECT_NEAR(thin[i + 1], 0.05, 1e-12);
    double nearest = 1.0;
    for (std::size_t j = 0; j < wide.size(); j += 3)
      nearest = std::min(nearest, std::hypot(thin[i] - wide[j], thin[i + 2] - wide[j + 2]));
    EXPECT_LT(nearest, 1e-9);
  }
}

}  // namespace
}  // namespace scarp::test
