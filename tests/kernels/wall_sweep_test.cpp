// SPDX-License-Identifier: BSD-3-Clause
/// Velocity and stress of dummy particles against the scalar reference, a hydrostatic and a linear
/// closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "kernels/isa/kernel_table.hpp"
#include "kernels/pair/force_correction.hpp"
#include "tests/support/packed_particles.hpp"
#include "tests/support/particle_blocks.hpp"

namespace scarp::test {
namespace {

using namespace kernels;

ReferenceSettings wall_settings(ReferenceSmoothing smoothing, int dimension) {
  ReferenceSettings s;
  s.dimension = dimension;
  s.smoothing = smoothing;
  s.spacing = 0.25;
  s.smoothing_length =
      1.6 * s.spacing;  // the third layer must not graze the rim, where stress is cut to 0
  s.gravity = {1.5, -9.81, dimension == 3 ? 0.7 : 0.0};
  return s;
}

/// Components by dummy, as the wall sweep of one instruction set leaves them.
struct Swept {
  std::array<std::vector<double>, 3> velocity;
  std::array<std::vector<double>, 10> stress;  ///< or what else is summed
  std::vector<double> weight, height, overburden;
};

Swept swept(const KernelTable& table, const ReferenceParticles& p, const ReferenceSettings& s,
            WallSums what = WallSums::extrapolation) {
  const PackedParticles packed(
      p, s, table.cluster_size,
      what == WallSums::corrected_stress ? Packing::corrected_force : Packing::plain);
  Swept out;
  WallSweepView<double> view = packed.wall_view();
  const auto slots = static_cast<std::size_t>(packed.wall_clusters() * table.cluster_size);
  for (std::size_t a = 0; a < 3; ++a) {
    out.velocity[a].assign(slots, 7.0);
    view.velocity[a] = s.dimension == 2 && a > 1 ? nullptr : out.velocity[a].data();
  }
  for (std::size_t c = 0; c < out.stress.size(); ++c) {
    out.stress[c].assign(slots, 1.0);
    view.sums[c] = out.stress[c].data();
  }
  for (const auto& [values, to] : {std::pair{&out.weight, &view.weight},
                                   {&out.height, &view.height},
                                   {&out.overburden, &view.overburden}}) {
    values->assign(slots, 1.0);
    *to = values->data();
  }
  table.wall_sweep[static_cast<std::size_t>(what)][static_cast<std::size_t>(s.dimension - 2)](
      view, 0, packed.wall_clusters());
  return out;
}

TEST(WallSweepTest, AgreesWithTheReference) {
  for (const int dimension : {2, 3}) {
    for (const auto smoothing : {ReferenceSmoothing::yang_liu, ReferenceSmoothing::cubic_spline,
                                 ReferenceSmoothing::wendland_c2}) {
      const ReferenceSettings s = wall_settings(smoothing, dimension);
      BlockOptions options;
      options.dimension = dimension;
      options.cells = dimension == 2 ? 12 : 6;
      options.jitter = 0.05;
      ReferenceParticles p = random_block(options, 3);
      // One dummy far from all soil: its stress is zero.
      p.position[p.soil_count + p.wall_count - 1] = {-20.0, 50.0, 0.0};
      const auto expected = wall_sweep_reference(p, s);
      ASSERT_EQ(expected.back().stress[0].value, 0.0);
      ASSERT_EQ(expected.back().velocity[0].value, p.velocity[p.soil_count][0]);
      for (const Isa isa : available_isas()) {
        const auto actual = swept(kernels_of(isa), p, s);
        for (std::size_t w = 0; w < expected.size(); ++w) {
          for (std::size_t c = 0; c < (dimension == 2 ? 4u : 6u); ++c) {
            // Weights at the rim of the support, where W is the cube of a small difference, carry
            // the rounding of the positions: 1e-10 of the largest term per term.
            ASSERT_NEAR(actual.stress[c][w], expected[w].stress[c].value,
                        1e-10 * expected[w].stress[c].largest)
                << isa_name(isa) << " " << form_of(smoothing).name << " " << dimension << "D dummy "
                << w << " component " << c;
          }
          for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
            ASSERT_NEAR(actual.velocity[a][w], expected[w].velocity[a].value,
                        1e-10 * expected[w].velocity[a].largest)
                << isa_name(isa) << " " << form_of(smoothing).name << " " << dimension << "D dummy "
                << w << " component " << a;
          }
        }
        const auto gradient = swept(kernels_of(isa), p, s, WallSums::gradient),
                   stress = swept(kernels_of(isa), p, s, WallSums::corrected_stress),
                   weights = swept(kernels_of(isa), p, s, WallSums::weight);
        // The sweep sums over weights in units of alpha_D / h^d.
        const double unit =
            form_of(smoothing).normalisation(dimension) / std::pow(s.smoothing_length, dimension);
        for (std::size_t w = 0; w < expected.size(); ++w) {
          const double h = s.smoothing_length;
          for (const Swept* sums : {&gradient, &stress, &weights}) {
            ASSERT_NEAR(sums->weight[w] * unit, expected[w].weight, 1e-10 * unit);
            ASSERT_NEAR(sums->height[w] * h, expected[w].height.value, 1e-10 * h);
          }
          ASSERT_NEAR(stress.overburden[w], expected[w].overburden.value,
                      1e-10 * expected[w].overburden.largest);
          for (int a = 0; a < dimension; ++a) {
            for (int b = 0; b < dimension; ++b) {
              const auto c = static_cast<std::size_t>(3 * a + b);
              const auto place = static_cast<std::size_t>(corrected_place_of(dimension, a, b));
              ASSERT_NEAR(gradient.stress[c][w] / unit, expected[w].gradient[c].value,
                          1e-10 * expected[w].gradient[c].largest)
                  << isa_name(isa) << " " << dimension << "D dummy " << w << " component " << c;
              const double overburden = a == b ? stress.overburden[w] : 0.0;
              ASSERT_NEAR(stress.stress[place][w] + overburden, expected[w].force_stress[c].value,
                          1e-10 * expected[w].force_stress[c].largest)
                  << isa_name(isa) << " " << dimension << "D dummy " << w << " component " << c;
            }
          }
        }
      }
    }
  }
}

TEST(WallSweepTest, ContinuesAHydrostaticStressExactly) {
  // sigma = rho g.x I is linear, so the gravity term takes every neighbour's stress to the dummy's
  // place.
  const ReferenceSettings s = wall_settings(ReferenceSmoothing::wendland_c2, 2);
  ReferenceParticles p = random_block({.dimension = 2, .cells = 12, .jitter = 0.1}, 5);
  const auto hydrostatic = [&](std::size_t k) {
    return -1800.0 * (s.gravity[0] * p.position[k][0] + s.gravity[1] * p.position[k][1]);
  };
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.density[k] = 1800.0;
    p.stress[k] = {hydrostatic(k), hydrostatic(k), hydrostatic(k), 0.0, 0.0, 0.0};
  }
  const auto expected = wall_sweep_reference(p, s);
  for (const Isa isa : available_isas()) {
    const auto actual = swept(kernels_of(isa), p, s);
    int near = 0;
    for (std::size_t w = 0; w < expected.size(); ++w) {
      if (expected[w].stress[0].largest == 0.0) continue;
      ++near;
      // Stresses up to 6e4 Pa at 20 neighbours: 1e-11 of that.
      ASSERT_NEAR(actual.stress[yy][w], hydrostatic(p.soil_count + w), 6e-7)
          << isa_name(isa) << " dummy " << w;
      ASSERT_NEAR(actual.stress[xy][w], 0.0, 6e-7);
    }
    ASSERT_EQ(near, 36);
  }
}

TEST(WallSweepTest, ContinuesALinearVelocityExactlyUpToTheLimit) {
  for (const int dimension : {2, 3}) {
    const ReferenceSettings s = wall_settings(ReferenceSmoothing::cubic_spline, dimension);
    ReferenceParticles p =
        random_block({.dimension = dimension, .cells = dimension == 2 ? 12 : 6, .jitter = 0.1}, 5);
    const std::array<double, 3> of_wall = p.velocity[p.soil_count];
    const std::array<double, 3> rate{2.0, -1.5, dimension == 3 ? 0.5 : 0.0};
    // Soil from 1.7 spacings above the face, over three times the depth of the first layer; the
    // second layer is out of its reach.
    for (std::size_t k = 0; k < p.size(); ++k) {
      if (p.is_wall(k)) continue;
      p.position[k][1] += 1.3 * s.spacing;
      for (std::size_t a = 0; a < 3; ++a)
        p.velocity[k][a] = of_wall[a] + rate[a] * p.position[k][1];
    }
    for (const Isa isa : available_isas()) {
      const Swept actual = swept(kernels_of(isa), p, s);
      int first_layer = 0;
      for (std::size_t w = 0; w < p.wall_count; ++w) {
        const double y = p.position[p.soil_count + w][1];
        if (y < -0.6 * s.spacing) continue;
        ++first_layer;
        for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
          // Velocities of about 1 m/s from a quotient of sums near the rim of the support.
          ASSERT_NEAR(actual.velocity[a][w], of_wall[a] + rate[a] * y, 1e-10)
              << isa_name(isa) << " " << dimension << "D dummy " << w << " component " << a;
        }
      }
      ASSERT_EQ(first_layer, dimension == 2 ? 12 : 36);
    }
  }
}

TEST(WallSweepTest, SoilAtTheFaceSeesItsVelocityComeBackUpToTheLimit) {
  const ReferenceSettings s = wall_settings(ReferenceSmoothing::cubic_spline, 2);
  ReferenceParticles p = random_block({.dimension = 2, .cells = 12, .jitter = 0.0}, 5);
  const std::array<double, 3> of_wall = p.velocity[p.soil_count];
  for (std::size_t k = 0; k < p.size(); ++k) {
    if (p.is_wall(k))
      p.face[k].limit = k % 3 == 0 ? 0.5 : 0.25;
    else
      p.velocity[k] = {of_wall[0] + 1.0, of_wall[1] - 2.0, 0.0};
  }
  for (const Isa isa : available_isas()) {
    const Swept actual = swept(kernels_of(isa), p, s);
    int touched = 0;
    for (std::size_t w = 0; w < p.wall_count; ++w) {
      if (p.position[p.soil_count + w][1] < -2.0 * s.spacing) continue;
      ++touched;
      const double limit = p.face[p.soil_count + w].limit;
      ASSERT_NEAR(actual.velocity[0][w], of_wall[0] - limit, 1e-12) << isa_name(isa);
      ASSERT_NEAR(actual.velocity[1][w], of_wall[1] + 2.0 * limit, 1e-12) << isa_name(isa);
    }
    ASSERT_EQ(touched, 24);
  }
}

}  // namespace
}  // namespace scarp::test
