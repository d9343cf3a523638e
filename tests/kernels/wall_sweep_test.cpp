// SPDX-License-Identifier: BSD-3-Clause
/// Stress of dummy particles against the scalar reference and a hydrostatic closed form.
#include <gtest/gtest.h>

#include "kernels/isa/kernel_table.hpp"
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

/// Runs the wall sweep of one instruction set; component c of dummy w is at [c][w].
std::array<std::vector<double>, 6> swept(const KernelTable& table, const ReferenceParticles& p,
                                         const ReferenceSettings& s) {
  const PackedParticles packed(p, s, table.cluster_size);
  std::array<std::vector<double>, 6> stress;
  WallSweepView<double> view = packed.wall_view();
  for (std::size_t c = 0; c < 6; ++c) {
    stress[c].assign(static_cast<std::size_t>(packed.wall_clusters() * table.cluster_size), 1.0);
    view.stress[c] = s.dimension == 2 && c > 3 ? nullptr : stress[c].data();
  }
  table.wall_sweep[static_cast<std::size_t>(s.dimension - 2)](view, 0, packed.wall_clusters());
  return stress;
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
      const auto expected = wall_stress_reference(p, s);
      ASSERT_EQ(expected.back()[0].value, 0.0);
      for (const Isa isa : available_isas()) {
        const auto actual = swept(kernels_of(isa), p, s);
        for (std::size_t w = 0; w < expected.size(); ++w) {
          for (std::size_t c = 0; c < (dimension == 2 ? 4u : 6u); ++c) {
            // Weights at the rim of the support, where W is the cube of a small difference, carry
            // the rounding of the positions: 1e-10 of the largest term per term.
            ASSERT_NEAR(actual[c][w], expected[w][c].value, 1e-10 * expected[w][c].largest)
                << isa_name(isa) << " " << form_of(smoothing).name << " " << dimension << "D dummy "
                << w << " component " << c;
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
  const auto expected = wall_stress_reference(p, s);
  for (const Isa isa : available_isas()) {
    const auto actual = swept(kernels_of(isa), p, s);
    int near = 0;
    for (std::size_t w = 0; w < expected.size(); ++w) {
      if (expected[w][0].largest == 0.0) continue;
      ++near;
      // Stresses up to 6e4 Pa at 20 neighbours: 1e-11 of that.
      ASSERT_NEAR(actual[yy][w], hydrostatic(p.soil_count + w), 6e-7)
          << isa_name(isa) << " dummy " << w;
      ASSERT_NEAR(actual[xy][w], 0.0, 6e-7);
    }
    ASSERT_EQ(near, 36);
  }
}

}  // namespace
}  // namespace scarp::test
