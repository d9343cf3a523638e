// SPDX-License-Identifier: BSD-3-Clause
/// Layers on rough walls under gravity that is not normal to them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

Facet facet_3d(const Vec3& origin, const Vec3& u, const Vec3& v, double length_u, double length_v,
               const Vec3& normal) {
  return {origin, u, v, length_u, length_v, normal};
}

/// A layer of 1 m, ten rows, on a rough base between smooth sides.
Scene tilted_layer(int dimension, double length, double along, double down) {
  Scene scene = elastic_column("modern", 1.0, 0.1);
  scene.dimension = dimension;
  scene.stages[0].damping = 30.0;
  if (dimension == 2) {
    scene.gravity = {along, -down, 0.0};
    scene.bodies = {{.shape = Box{{0, 0, 0}, {length, 1, 0}}}};
    scene.walls = {wall_of("base", WallKind::no_slip, {facet_2d(0, 0, length, 0)}),
                   wall_of("sides", WallKind::free_slip,
                           {facet_2d(length, 0, length, 2), facet_2d(0, 2, 0, 0)})};
    return scene;
  }
  scene.gravity = {along, 0.0, -down};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {length, 0.3, 1}}}};
  scene.walls = {wall_of("base", WallKind::no_slip,
                         {facet_3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, length, 0.3, {0, 0, 1})}),
                 wall_of("sides", WallKind::free_slip,
                         {facet_3d({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 2, length, {0, 1, 0}),
                          facet_3d({0, 0.3, 0}, {1, 0, 0}, {0, 0, 1}, length, 2, {0, -1, 0}),
                          facet_3d({0, 0, 0}, {0, 1, 0}, {0, 0, 1}, 0.3, 2, {1, 0, 0}),
                          facet_3d({length, 0, 0}, {0, 0, 1}, {0, 1, 0}, 2, 0.3, {-1, 0, 0})})};
  return scene;
}

/// Mean shear stress of each row in the middle of a layer at rest, in rho g_t dx.
std::vector<double> shear_of_rows(const Scene& scene, double length) {
  Simulation simulation(scene, {1, {}});
  while (!simulation.finished()) simulation.step();
  EXPECT_TRUE(simulation.stage_reached_rest());
  const auto position = simulation.field("position"), stress = simulation.field("stress"),
             displacement = simulation.field("displacement");
  const auto up = static_cast<std::size_t>(scene.dimension - 1);
  std::vector<double> sums(10), counts(10);
  for (std::size_t k = 0; k < simulation.soil_count(); ++k) {
    if (std::abs(position[3 * k] - displacement[3 * k] - 0.5 * length) > 0.25) continue;
    const auto row =
        static_cast<std::size_t>((position[3 * k + up] - displacement[3 * k + up]) / 0.1);
    sums[row] += stress[6 * k + (up == 1 ? 3 : 5)] / (2000.0 * scene.gravity[0] * 0.1);
    counts[row] += 1.0;
  }
  for (std::size_t row = 0; row < 10; ++row) sums[row] /= counts[row];
  return sums;
}

TEST(RoughWallTest, ShearOfATiltedLayerIsThatOfTheWeightAbove) {
  const auto shear = shear_of_rows(tilted_layer(2, 20.0, 3.3552, 9.2184), 20.0);
  // rho g_t (H - y), but for the two rows at the surface, where T and not sigma is in balance. The
  // normal stress has an error of 0.009 in the same rows; an average that keeps the shear constant
  // along the normal has +-0.58 from row to row.
  for (std::size_t row = 0; row < 8; ++row)
    EXPECT_NEAR(shear[row], 9.5 - static_cast<double>(row), 0.02) << row;
}

TEST(RoughWallTest, ShearOfATiltedLayerIn3DHasNoZigzag) {
  const auto shear = shear_of_rows(tilted_layer(3, 4.0, 3.3552, 9.2184), 4.0);
  // Zigzags of +-a have second differences of 4 a, here 2 without columns; the ends of so short a
  // layer bend the course of the shear by up to 0.12.
  for (std::size_t row = 1; row < 8; ++row)
    EXPECT_LT(std::abs(shear[row + 1] - 2.0 * shear[row] + shear[row - 1]), 0.15) << row;
}

TEST(RoughWallTest, SandBelowItsFrictionAngleStands) {
  // tan 26.6 deg over tan 30 deg is 0.87: an infinite layer stands. Where shear jumps from row to
  // row, some rows yield and the layer creeps at 9 mm/s for good.
  Scene scene = tilted_layer(2, 12.0, 4.4, 8.768);
  scene.materials = {
      {"sand", DruckerPrager{10e6, 0.3, 0.0, 0.5236, 0.0, Cone::plane_strain}, 2000.0}};
  scene.initial_stress = InitialStress::geostatic;
  scene.stages = {stage_for("stand", 3.0)};
  Simulation simulation(scene, {1, {}});
  const auto slip_at = [&](double until) {
    while (simulation.last_step().time < until) simulation.step();
    const auto position = simulation.field("position"),
               displacement = simulation.field("displacement");
    double most = 0.0;
    for (std::size_t k = 0; k < simulation.soil_count(); ++k) {
      if (std::abs(position[3 * k] - 6.0) < 1.0) most = std::max(most, displacement[3 * k]);
    }
    return most;
  };
  const double at_first = slip_at(1.0), later = slip_at(2.9);
  // It yields until it leans on its strength; after that 9 mm/s would add 17 mm.
  EXPECT_LT(at_first, 0.03);
  EXPECT_LT(later - at_first, 1e-3);
}

}  // namespace
}  // namespace scarp::test
