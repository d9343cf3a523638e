// SPDX-License-Identifier: BSD-3-Clause
/// What the tests of the pair sweeps share: smoothing functions, dimensions, settings, blocks.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <string>
#include <tuple>

#include "kernels/isa/kernel_table.hpp"
#include "tests/support/packed_particles.hpp"
#include "tests/support/particle_blocks.hpp"

namespace scarp::test {

using kernels::ReferenceSettings;
using kernels::ReferenceSmoothing;

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

inline ReferenceSettings settings_for(ReferenceSmoothing smoothing, int dimension) {
  ReferenceSettings s;
  s.dimension = dimension;
  s.smoothing = smoothing;
  s.spacing = 0.25;
  s.smoothing_length = 1.2 * s.spacing;
  s.lattice_moment = 0.95;
  s.viscosity_alpha = 0.1;
  s.viscosity_beta = 0.7;
  s.hourglass_viscosity = 0.3;
  s.gravity = dimension == 2 ? std::array<double, 3>{0.4, -9.8, 0.0}
                             : std::array<double, 3>{0.4, -1.0, -9.7};
  return s;
}

inline BlockOptions block_for(int dimension) {
  BlockOptions options;
  options.dimension = dimension;
  options.cells = dimension == 2 ? 12 : 6;
  return options;
}

/// One smoothing function in one dimension.
using SweepCase = std::tuple<ReferenceSmoothing, int>;

inline auto all_sweep_cases() {
  return testing::Combine(
      testing::Values(ReferenceSmoothing::yang_liu, ReferenceSmoothing::cubic_spline,
                      ReferenceSmoothing::wendland_c2),
      testing::Values(2, 3));
}

inline std::string name_of_case(const testing::TestParamInfo<SweepCase>& info) {
  return std::string(form_of(std::get<0>(info.param)).name) + "_" +
         std::to_string(std::get<1>(info.param)) + "D";
}

}  // namespace scarp::test
