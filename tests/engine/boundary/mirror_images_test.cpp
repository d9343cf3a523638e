// SPDX-License-Identifier: BSD-3-Clause
/// Mirror images in corners of smooth planes, against particles that are reflected one by one.
#include "engine/boundary/mirror_images.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "engine/boundary/facet_geometry.hpp"
#include "kernels/pair/list.hpp"
#include "kernels/tensor.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

using namespace kernels;
using geometry::cross;
using geometry::dot;
using geometry::minus;
using geometry::plus;

constexpr double smoothing_length = 0.15, reach = 0.3, density = 1700.0, k0 = 0.6;

using Matrix = std::array<std::array<double, 3>, 3>;

/// What a particle or an image is.
struct Point {
  Vec3 position{}, velocity{};
  Matrix stress{};
  Matrix tension{};         ///< of the second line
  Matrix inverse_moment{};  ///< B
};

/// Three smooth planes that meet at right angles, turned any way, each on a wall of its own.
struct Corner {
  std::array<Vec3, 3> axis{};
  Vec3 apex{0.4, -0.7, 1.1};
  std::array<Vec3, 3> velocity{};
  Scene scene;
  Vec3 gravity{};

  explicit Corner(std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    const auto any = [&] { return Vec3{number(random), number(random), number(random)}; };
    const auto unit = [](const Vec3& v) { return plus({}, 1.0 / std::sqrt(dot(v, v)), v); };
    axis[0] = unit(any());
    axis[1] = unit(cross(axis[0], any()));
    axis[2] = cross(axis[0], axis[1]);
    gravity = plus({}, 9.81, unit(any()));
    scene.dimension = 3;
    for (std::size_t a = 0; a < 3; ++a) {
      velocity[a] = any();
      const Facet facet{apex, axis[(a + 1) % 3], axis[(a + 2) % 3], 2.0, 2.0, axis[a]};
      scene.walls.push_back(wall_of("plane", WallKind::free_slip, {facet}));
    }
  }
  double distance(std::size_t plane, const Vec3& point) const {
    return dot(minus(point, apex), axis[plane]);
  }

  /// Equation: B3, with matrices written out.
  Point reflected(const Point& from, std::size_t plane) const {
    const Vec3& n = axis[plane];
    const double d = distance(plane, from.position);
    Point to;
    to.position = plus(from.position, -2.0 * d, n);
    to.velocity = plus(from.velocity, -2.0 * dot(minus(from.velocity, velocity[plane]), n), n);
    Matrix r{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) r[i][j] = (i == j ? 1.0 : 0.0) - 2.0 * n[i] * n[j];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const double along = n[i] * n[j];
        const double t = along + k0 * ((i == j ? 1.0 : 0.0) - along);
        to.stress[i][j] = 2.0 * d * density * dot(gravity, n) * t;
        to.inverse_moment[i][j] = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
          for (std::size_t l = 0; l < 3; ++l) {
            to.stress[i][j] += r[i][k] * from.stress[k][l] * r[j][l];
            to.tension[i][j] += r[i][k] * from.tension[k][l] * r[j][l];
            to.inverse_moment[i][j] += r[i][k] * from.inverse_moment[k][l] * r[j][l];
          }
        }
      }
    }
    return to;
  }

  /// Across every plane within reach, and those images across the planes after it.
  void add_images(const Point& from, std::size_t first, std::vector<Point>& images) const {
    for (std::size_t plane = first; plane < 3; ++plane) {
      if (distance(plane, from.position) > reach) continue;
      const Point image = reflected(from, plane);
      images.push_back(image);
      add_images(image, plane + 1, images);
    }
  }
};

void expect_same(const Point& image, const Point& wanted) {
  // Three reflections, each some ten roundings of the largest number that enters.
  constexpr double round_off = 100 * 2.2e-16;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(image.position[i], wanted.position[i], 5.0 * round_off);
    EXPECT_NEAR(image.velocity[i], wanted.velocity[i], 10.0 * round_off);
    for (std::size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(image.stress[i][j], wanted.stress[i][j], 1e5 * round_off);
      EXPECT_NEAR(image.tension[i][j], wanted.tension[i][j], 1e5 * round_off);
    }
  }
}

Matrix full(const double* s) {
  return {{{s[xx], s[xy], s[zx]}, {s[xy], s[yy], s[yz]}, {s[zx], s[yz], s[zz]}}};
}

constexpr int first_tension = first_second<PairTerms, ArtificialStress>;

Point read_record(const double* r, const double* second) {
  Point point;
  for (std::size_t a = 0; a < 3; ++a) {
    point.position[a] = r[record_x + a] * smoothing_length;
    point.velocity[a] = r[record_velocity_x + a];
  }
  point.stress = full(r + record_stress);
  point.tension = full(second + first_tension);
  return point;
}

/// sigma B.
Matrix corrected(const Point& point) {
  Matrix t{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k)
        t[i][j] += point.stress[i][k] * point.inverse_moment[k][j];
    }
  }
  return t;
}

bool before(const Point& a, const Point& b) { return a.position < b.position; }

TEST(MirrorImagesTest, A3DCornerIsFilledAsByReflectingEachParticle) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> inside(0.0, 2.0 * reach), number(-1.0, 1.0);
  for (int turn = 0; turn < 10; ++turn) {
    const Corner corner(random);
    constexpr std::int64_t count = 40;
    constexpr Field used[]{Field::position, Field::build_position, Field::velocity,
                           Field::density,  Field::stress,         Field::force_moment};
    ParticleBuffers soil(
        3, {{{.reference_density = density, .mass = 1.0}, 0, count, padded(count)}}, used);
    std::vector<Point> wanted;
    std::array<std::array<double, 6>, count> tension{};
    for (std::int64_t k = 0; k < count; ++k) {
      Point point;
      point.position = corner.apex;
      for (const Vec3& axis : corner.axis)
        point.position = plus(point.position, inside(random), axis);
      double s[6];
      for (int c = 0; c < 6; ++c) soil.component(Field::stress, c)[k] = s[c] = 1e4 * number(random);
      point.stress = full(s);
      if (k % 2 == 0) {  // the others have been in no tension
        for (double& t : tension[static_cast<std::size_t>(k)]) t = 1e4 * number(random);
      }
      point.tension = full(tension[static_cast<std::size_t>(k)].data());
      // Its inverse is found by the engine; here B is chosen diagonal, turned by a reflection.
      const Vec3 n = corner.axis[0];
      const double moment[3] = {0.5 + 0.2 * number(random), 0.9, 1.1};
      SymTensor<double> m{};
      for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t j = 0; j < 3; ++j) {
            const double ia = (i == a ? 1.0 : 0.0) - 2.0 * n[i] * n[a],
                         ja = (j == a ? 1.0 : 0.0) - 2.0 * n[j] * n[a];
            point.inverse_moment[i][j] += ia * ja / moment[a];
          }
        }
        const double r[3] = {(a == 0 ? 1.0 : 0.0) - 2.0 * n[0] * n[a],
                             (a == 1 ? 1.0 : 0.0) - 2.0 * n[1] * n[a],
                             (a == 2 ? 1.0 : 0.0) - 2.0 * n[2] * n[a]};
        m = m + moment[a] * SymTensor<double>{r[0] * r[0], r[1] * r[1], r[2] * r[2],
                                              r[0] * r[1], r[1] * r[2], r[2] * r[0]};
      }
      const double of_moment[6] = {m.xx, m.yy, m.zz, m.xy, m.yz, m.zx};
      for (int c = 0; c < 6; ++c) soil.component(Field::force_moment, c)[k] = of_moment[c];
      for (int a = 0; a < 3; ++a) {
        const auto axis = static_cast<std::size_t>(a);
        point.velocity[axis] = number(random);
        soil.component(Field::position, a)[k] = point.position[axis];
        soil.component(Field::velocity, a)[k] = point.velocity[axis];
      }
      corner.add_images(point, 0, wanted);
    }
    const WallSurface surface(corner.scene);
    const std::vector<bool> stands(3, true);
    const std::vector<Vec3> offset(3);
    const std::vector<Vec3> velocity(corner.velocity.begin(), corner.velocity.end());
    const PointSpan points{soil.component(Field::position, 0), soil.component(Field::position, 1),
                           soil.component(Field::position, 2)};
    const SlotRange range{0, count};
    MirrorImages images;
    images.select(1, {corner.scene, surface, {stands, offset}, reach},
                  {points, {&range, 1}, {&k0, 1}, 0}, {}, 0.1, {});
    ASSERT_EQ(images.count(), static_cast<std::int64_t>(wanted.size()));
    const RecordScaling scaling{1.0 / smoothing_length, 1.0, {1e7}};
    Records records(soil.slots(), 0);
    records.pack(1, Role::owned, soil, scaling, kernels::sound_speed_slot, StressForm::plain);
    records.resize(1, 0, images.count());
    const MirrorImages::Mirrors mirrors{scaling.inverse_smoothing_length, offset, velocity,
                                        corner.gravity};
    images.pack(1, records, mirrors, {});
    records.take_second();
    for (std::int64_t k = 0; k < count; k += 2) {
      std::copy_n(tension[static_cast<std::size_t>(k)].data(), 6,
                  records.second(k) + first_tension);
      records.mark(k) = 1;
    }
    images.pack_second(1, records, TermSet{Term::artificial_stress}, 3);
    std::vector<Point> made;
    for (std::int64_t g = 0; g < images.count(); ++g) {
      const std::int64_t index = records.layout()[Role::image].first + g;
      made.push_back(read_record(records.record(index), records.second(index)));
    }
    std::sort(made.begin(), made.end(), before);
    std::sort(wanted.begin(), wanted.end(), before);
    for (std::size_t g = 0; g < wanted.size(); ++g) expect_same(made[g], wanted[g]);
    records.pack(1, Role::owned, soil, scaling, kernels::sound_speed_slot, StressForm::corrected);
    images.pack_corrected(1, records, mirrors, soil, {}, {});
    std::vector<std::pair<Vec3, Tensor<double>>> taken;
    for (std::int64_t g = 0; g < images.count(); ++g) {
      const std::int64_t record = records.layout()[Role::image].first + g;
      taken.emplace_back(read_record(records.record(record), records.second(record)).position,
                         records.corrected_stress(record, 3));
    }
    std::sort(taken.begin(), taken.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t g = 0; g < wanted.size(); ++g) {
      const Matrix t = corrected(wanted[g]);
      for (std::size_t i = 0; i < 3; ++i) {
        // Of sigma, times B of up to 3.3, and the inverse of M.
        for (std::size_t j = 0; j < 3; ++j)
          EXPECT_NEAR(taken[g].second.m[i][j], t[i][j], 4e5 * 100 * 2.2e-16);
      }
    }
    for (std::int64_t k = 0; k < count; ++k) {
      const Vec3 place{points.x[k], points.y[k], points.z[k]};
      bool close = false;
      for (std::size_t plane = 0; plane < 3; ++plane)
        close = close || corner.distance(plane, place) <= 0.1;
      EXPECT_EQ(images.is_close(k, 1), close);
    }
  }
}

TEST(MirrorImagesTest, ThreadsChangeNothingAndSourcesComeFirst) {
  std::mt19937 random(12);
  std::uniform_real_distribution<double> inside(0.0, 2.0 * reach);
  const Corner corner(random);
  constexpr std::size_t count = 3000;
  AlignedVector<double> axes[3];
  for (std::size_t k = 0; k < count; ++k) {
    Vec3 point = corner.apex;
    for (const Vec3& axis : corner.axis) point = plus(point, inside(random), axis);
    for (std::size_t a = 0; a < 3; ++a) axes[a].push_back(point[a]);
  }
  const WallSurface surface(corner.scene);
  const std::vector<bool> stands(3, true);
  const std::vector<Vec3> offset(3);
  const SlotRange ranges[] = {{0, 1300}, {1312, count}};
  const double both[] = {k0, 0.5};
  const FastGrains fast{{1, 1400}, 0.1};
  const auto images_by = [&](int threads) {
    MirrorImages images;
    for (int k = 0; k < 2; ++k) {  // in memory that is there too
      images.select(threads, {corner.scene, surface, {stands, offset}, reach},
                    {{axes[0].data(), axes[1].data(), axes[2].data()}, ranges, both, 0}, {}, 0.1,
                    fast);
    }
    std::vector<double> all;
    for (std::int64_t g = 0; g < images.count(); ++g) {
      EXPECT_LT(images.soil_of(g), static_cast<std::int64_t>(count));
      all.insert(all.end(),
                 {images.points().x[g], images.points().y[g], images.points().z[g],
                  static_cast<double>(images.soil_of(g)), static_cast<double>(images.wall_of(g))});
    }
    for (const std::int64_t g : images.fast(threads)) all.push_back(static_cast<double>(g));
    EXPECT_GT(images.count(), static_cast<std::int64_t>(count));
    // Moved by what they are images of, one after the other, they stay.
    const std::vector<double> x(images.points().x, images.points().x + images.count());
    images.follow({axes[0].data(), axes[1].data(), axes[2].data()});
    EXPECT_EQ(x, std::vector<double>(images.points().x, images.points().x + images.count()));
    return all;
  };
  const std::vector<double> one = images_by(1);
  for (const int threads : {2, 4, 8}) EXPECT_EQ(images_by(threads), one) << threads;
}

}  // namespace
}  // namespace scarp::test
