// SPDX-License-Identifier: BSD-3-Clause
/// Soil packed anew beside walls that the lattice does not meet: sums over all pairs, with images
/// that are reflected one by one.
#include "engine/boundary/relaxed_packing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/particles/generate.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "engine/scene/vector.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

using geometry::dot;
using geometry::minus;
using geometry::plus;

constexpr double width = 1.2, depth = 0.4, height = 1.0, dx = 0.1;

/// A trough with a rough base and smooth sides, turned by an angle about the normal of its plane
/// (in 3D about y), and filled to `height`.
struct Trough {
  int dimension;
  double angle;
  Scene scene;

  Trough(int dimension_, double degrees, double offset = 0.0)
      : dimension(dimension_), angle(degrees * std::numbers::pi / 180.0) {
    scene.dimension = dimension;
    scene.spacing = dx;
    scene.materials = {clay()};
    Polygon outline;
    for (const auto& [s, n] :
         {std::array{0.0, 0.0}, {width + offset, 0.0}, {width + offset, height}, {0.0, height}}) {
      const Vec3 corner = place(s, n, 0.0);
      outline.points.push_back({corner[0], corner[up()]});
    }
    outline.extrude = {0.0, depth};
    scene.bodies = {{.shape = outline}};
    const double top = height + 0.5, right = width + offset;
    scene.walls = {wall_of("base", WallKind::no_slip, {face(-0.3, 0.0, right + 0.3, 0.0)}),
                   wall_of("left", WallKind::free_slip, {face(0.0, top, 0.0, 0.0)}),
                   wall_of("right", WallKind::free_slip, {face(right, 0.0, right, top)})};
    if (dimension == 3) {
      scene.walls.push_back(
          wall_of("front", WallKind::free_slip,
                  {{place(0, 0, 0), axis(0, 1), axis(1, 0), top, right, {0, 1, 0}}}));
      scene.walls.push_back(
          wall_of("back", WallKind::free_slip,
                  {{place(0, 0, depth), axis(1, 0), axis(0, 1), right, top, {0, -1, 0}}}));
    }
    const Vec3 down = axis(0, -1);
    for (std::size_t a = 0; a < 3; ++a) scene.gravity[a] = 9.81 * down[a];
    scene.stages = {stage_for("only", 1.0)};
  }

  std::size_t up() const { return dimension == 2 ? 1 : 2; }
  Vec3 axis(double along, double normal) const {
    const double c = std::cos(angle), s = std::sin(angle);
    Vec3 turned{};
    turned[0] = c * along - s * normal;
    turned[up()] = s * along + c * normal;
    return turned;
  }
  Vec3 place(double along, double normal, double y) const {
    Vec3 point = axis(along, normal);
    if (dimension == 3) point[1] = y;
    return point;
  }
  /// With the soil on its left.
  Facet face(double s0, double n0, double s1, double n1) const {
    const double length = std::hypot(s1 - s0, n1 - n0), ts = (s1 - s0) / length,
                 tn = (n1 - n0) / length;
    return {
        place(s0, n0, 0.0),           axis(ts, tn), dimension == 2 ? Vec3{} : Vec3{0, 1, 0}, length,
        dimension == 2 ? 0.0 : depth, axis(-tn, ts)};
  }
  double along(const Vec3& point) const { return dot(point, axis(1, 0)); }
  double normal(const Vec3& point) const { return dot(point, axis(0, 1)); }

  RelaxedPacking relax(Particles& soil, int threads = 1) const {
    return relax_packing(scene, WallSurface(scene), generate_dummies(scene), threads, {}, soil);
  }

  /// Soil, dummies, and images of the soil in every smooth wall and corner of two or three.
  std::vector<Vec3> neighbours(const std::vector<Vec3>& soil) const {
    std::vector<Vec3> all = soil;
    for (const Wall& wall : scene.walls) {
      if (wall.kind == WallKind::no_slip) continue;
      const Facet& facet = wall.facets.front();
      const std::size_t before = all.size();
      for (std::size_t k = 0; k < before; ++k) {
        const double distance = dot(minus(all[k], facet.origin), facet.normal);
        all.push_back(plus(all[k], -2.0 * distance, facet.normal));
      }
    }
    const WallDummies dummies = generate_dummies(scene);
    for (std::size_t k = 0; k < dummies.position.size(); ++k) {
      if (dummies.distance[k] > 0.0) all.push_back(dummies.position[k]);
    }
    return all;
  }

  /// rms of |sum V grad W| dx over the soil that does not see the free surface.
  double residual(const std::vector<Vec3>& soil) const {
    const kernels::SmoothingForm& form = smoothing_of(scene);
    const double ratio = smoothing_ratio_of(scene), h = ratio * dx;
    const double volume = form.normalisation(dimension) / std::pow(ratio, dimension + 1);
    const std::vector<Vec3> all = neighbours(soil);
    double squares = 0.0;
    int count = 0;
    for (const Vec3& point : soil) {
      if (normal(point) > height - 2.0 * h - dx) continue;
      Vec3 sum{};
      for (const Vec3& other : all) {
        const Vec3 from = minus(point, other);
        const double r = std::sqrt(dot(from, from));
        if (r > 1e-9 && r < 2.0 * h) sum = plus(sum, volume * form.slope(r / h) / r, from);
      }
      squares += dot(sum, sum);
      ++count;
    }
    return std::sqrt(squares / count);
  }
};

class RelaxedPackingTest : public testing::TestWithParam<int> {};

TEST_P(RelaxedPackingTest, LeavesALatticeThatMeetsItsWallsAsItIs) {
  const Trough trough(GetParam(), 0.0);
  Particles soil = generate_soil(trough.scene);
  const std::vector<Vec3> before = soil.position;
  EXPECT_EQ(trough.relax(soil).moved, 0u);
  EXPECT_EQ(soil.position, before);
}

/// The descent ends at a residual of 1e-3; here the sum is over the same neighbours, but for
/// particles whose neighbours end in the standing lattice or beyond the surface.
TEST_P(RelaxedPackingTest, BringsTheSumOfGradientsToZeroBesideWallsAskew) {
  for (const double degrees : {10.0, 30.0, 45.0, -20.0}) {
    const Trough trough(GetParam(), degrees);
    Particles soil = generate_soil(trough.scene);
    const double before = trough.residual(soil.position);
    const RelaxedPacking packing = trough.relax(soil);
    // At 45 degrees the lattice is moved to stand about half a row from its walls: 0.025.
    EXPECT_GT(before, 0.02) << degrees;
    EXPECT_LT(trough.residual(soil.position), 2e-3) << degrees;
    EXPECT_LT(packing.residual, 1e-3) << degrees;
    EXPECT_EQ(packing.moved, soil.position.size()) << degrees << ": all is near a wall here";
  }
}

/// A wall along the lattice but not at a multiple of the spacing: the rows share what is missing
/// evenly, so that a tenth or so of it is left where they end.
TEST_P(RelaxedPackingTest, MendsAWallBetweenTwoRows) {
  const Trough trough(GetParam(), 0.0, 0.03);
  Particles soil = generate_soil(trough.scene);
  const double before = trough.residual(soil.position);
  trough.relax(soil);
  EXPECT_LT(trough.residual(soil.position), 0.2 * before);
}

TEST_P(RelaxedPackingTest, KeepsSoilInItsTroughAndItsSurfaceWhereItWas) {
  const Trough trough(GetParam(), 30.0);
  Particles soil = generate_soil(trough.scene);
  const std::vector<Vec3> before = soil.position;
  trough.relax(soil);
  double rise = 0.0;
  int at_surface = 0;
  for (std::size_t k = 0; k < soil.position.size(); ++k) {
    const Vec3& point = soil.position[k];
    // Rows settle half a spacing from a wall; disorder leaves some at a fifth.
    EXPECT_GT(trough.normal(point), 0.1 * dx);
    EXPECT_GT(trough.along(point), 0.1 * dx);
    EXPECT_LT(trough.along(point), width - 0.1 * dx);
    if (trough.normal(before[k]) < height - dx) continue;
    rise += trough.normal(point) - trough.normal(before[k]);
    ++at_surface;
  }
  // Beyond the surface the lattice goes on. The outline is known to half a spacing, and what that
  // leaves is spread over the rows.
  EXPECT_LT(std::abs(rise / at_surface), 0.1 * dx);
}

TEST_P(RelaxedPackingTest, GivesTheSameBitsForAnyNumberOfThreads) {
  const Trough trough(GetParam(), 30.0);
  Particles one = generate_soil(trough.scene), three = one;
  trough.relax(one, 1);
  trough.relax(three, 3);
  EXPECT_EQ(one.position, three.position);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, RelaxedPackingTest, testing::Values(2, 3));

/// A particle whose centre lies on a smooth face coincides with its image; nothing would part them.
TEST(RelaxedPackingTest, PartsAParticleOnASmoothFaceFromItsImage) {
  Trough trough(2, 0.0);
  trough.scene.bodies = {{.shape = Box{{-0.05, 0, 0}, {width, height, 0}}}};
  Particles soil = generate_soil(trough.scene);
  const double nearest =
      std::abs(std::min_element(soil.position.begin(), soil.position.end())->front());
  ASSERT_LT(nearest, 1e-9);
  trough.relax(soil);
  for (const Vec3& point : soil.position) EXPECT_GT(point[0], 0.1 * dx);
}

/// Bodies that end a little short of their walls: sites of the lattice in the gaps belong to
/// nobody, and no place is kept for them. Beside a wall particles stand a spacing apart, less in
/// disorder.
TEST(RelaxedPackingTest, LeavesNoHolesWhereABodyEndsShortOfItsWall) {
  for (const double degrees : {7.0, 15.0, 30.0, 40.0}) {
    for (const double gap : {0.001, 0.003, 0.01, 0.02}) {
      Trough trough(2, degrees);
      auto& outline = std::get<Polygon>(trough.scene.bodies[0].shape).points;
      const double low = gap, right = width - gap;
      const std::array<std::array<double, 2>, 4> inset{
          {{low, low}, {right, low}, {right, height}, {low, height}}};
      for (std::size_t k = 0; k < 4; ++k) {
        const Vec3 corner = trough.place(inset[k][0], inset[k][1], 0.0);
        outline[k] = {corner[0], corner[1]};
      }
      Particles soil = generate_soil(trough.scene);
      trough.relax(soil);
      double widest = 0.0;
      for (double s = 0.5 * dx; s < height - dx; s += 0.1 * dx) {
        for (const Vec3& place : {trough.place(0.5 * dx, s, 0.0), trough.place(s, 0.5 * dx, 0.0),
                                  trough.place(width - 0.5 * dx, s, 0.0)}) {
          double nearest = 1.0;
          for (const Vec3& point : soil.position) {
            const Vec3 way = minus(point, place);
            nearest = std::min(nearest, std::sqrt(dot(way, way)));
          }
          widest = std::max(widest, nearest);
        }
      }
      EXPECT_LT(widest, 0.8 * dx) << degrees << ' ' << gap;
    }
  }
}

/// A roof at 45 deg through sites of the lattice: particles lie on its face, and no empty site
/// beyond it may take part. Two corners of 45 deg are left, where dummies of both walls crowd.
TEST(RelaxedPackingTest, FillsATriangleUnderARoofEvenly) {
  Scene scene;
  scene.spacing = dx;
  scene.materials = {clay()};
  scene.bodies = {{.shape = Polygon{{{0, 0}, {0.8, 0}, {0.8, 0.8}}}}};
  scene.walls = {
      wall_of("all", WallKind::no_slip,
              {facet_2d(0, 0, 0.8, 0), facet_2d(0.8, 0, 0.8, 0.8), facet_2d(0.8, 0.8, 0, 0)})};
  Particles soil = generate_soil(scene);
  relax_packing(scene, WallSurface(scene), generate_dummies(scene), 1, {}, soil);
  for (std::size_t k = 0; k < soil.position.size(); ++k) {
    const Vec3& a = soil.position[k];
    EXPECT_LT(a[1], a[0]);
    for (std::size_t j = 0; j < k; ++j) {
      const Vec3 apart = minus(a, soil.position[j]);
      // 36 particles share the room of 32.
      EXPECT_GT(std::sqrt(dot(apart, apart)), 0.5 * dx);
    }
  }
}

/// Under gravity along an axis the weight above is known by columns of the lattice, and follows
/// each particle from there: along the wall of a bin that is wider above, gamma times the depth.
TEST(RelaxedPackingTest, GivesAGeostaticStartThePressureOfWhereParticlesAre) {
  Scene scene;
  scene.spacing = dx;
  scene.materials = {clay()};
  scene.bodies = {{.shape = Polygon{{{0, 0}, {1, 0}, {1.6, 1}, {0, 1}}}}};
  scene.walls = {wall_of("bin", WallKind::free_slip,
                         {facet_2d(0, 1.5, 0, 0), facet_2d(0, 0, 1, 0), facet_2d(1, 0, 1.9, 1.5)})};
  scene.initial_stress = InitialStress::geostatic;
  scene.stages = {stage_for("only", 1.0)};
  for (const bool relaxed : {false, true}) {
    scene.numerics.relaxed_packing = relaxed;
    const Simulation simulation(scene, RunOptions{.threads = 1});
    const auto position = simulation.field("position"), stress = simulation.field("stress");
    double moved = 0.0;
    for (std::size_t k = 0; k < simulation.soil_count(); ++k) {
      const double y = position[3 * k + 1];
      EXPECT_NEAR(stress[6 * k + 1], -2000.0 * 9.81 * (1.0 - y), 1e-9 * 2000.0 * 9.81);
      const double cell = y / dx - 0.5;
      moved = std::max(moved, std::abs(cell - std::round(cell)));
    }
    if (relaxed) {
      EXPECT_GT(moved, 0.05);
    } else {
      EXPECT_LT(moved, 1e-9);
    }
  }
}

/// An inclined sheet pile: soil on one side stands behind the face of the other, near enough to be
/// asked about, and must not be moved before it.
TEST(RelaxedPackingTest, LeavesSoilOnItsSideOfAnInclinedPile) {
  Scene scene;
  scene.spacing = dx;
  scene.materials = {clay()};
  scene.bodies = {{.shape = Polygon{{{0, 0}, {4, 0}, {5, 3}, {0, 3}}}},
                  {.shape = Polygon{{{4.3, 0}, {10, 0}, {10, 3}, {5.3, 3}}}}};
  scene.walls = {
      wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 10, 0)}),
      wall_of("pile", WallKind::no_slip,
              {facet_2d(4, 0, 5, 3), facet_2d(5, 3, 5.3, 3), facet_2d(5.3, 3, 4.3, 0)}),
      wall_of("sides", WallKind::free_slip, {facet_2d(0, 4, 0, 0), facet_2d(10, 0, 10, 4)})};
  Particles soil = generate_soil(scene);
  const std::vector<Vec3> before = soil.position;
  EXPECT_GT(relax_packing(scene, WallSurface(scene), generate_dummies(scene), 1, {}, soil).moved,
            100u);
  const auto left_of = [](const Vec3& p) { return p[0] < 4.15 + p[1] / 3.0; };
  for (std::size_t k = 0; k < before.size(); ++k) {
    EXPECT_EQ(left_of(soil.position[k]), left_of(before[k]));
    const Vec3 way = minus(soil.position[k], before[k]);
    EXPECT_LT(std::sqrt(dot(way, way)), 0.7 * dx);  // rows come from where the lattice has them
  }
}

/// What a program brings along stays where it put it.
TEST(RelaxedPackingTest, LeavesGivenParticlesAlone) {
  const Trough trough(2, 30.0);
  const Particles soil = generate_soil(trough.scene);
  const Simulation simulation(trough.scene, soil, RunOptions{.threads = 1});
  const auto position = simulation.field("position");
  for (std::size_t k = 0; k < soil.position.size(); ++k) {
    EXPECT_EQ(position[3 * k], soil.position[k][0]);
    EXPECT_EQ(position[3 * k + 1], soil.position[k][1]);
  }
}

}  // namespace
}  // namespace scarp::test
