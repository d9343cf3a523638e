// SPDX-License-Identifier: BSD-3-Clause
/// Storage of the particles.
#include "engine/particles/particle_buffers.hpp"

#include <gtest/gtest.h>

#include <array>

namespace scarp::test {
namespace {

/// Sixteen slots in reverse order: where does slot 0 find its density and its xy gradient?
std::array<double, 2> after_reversal(std::span<const Field> also) {
  constexpr Field used[]{Field::density, Field::velocity_gradient};
  ParticleBuffers particles(2, {{0, 16, 16, 0}}, used);
  std::array<std::int32_t, 16> order{};
  for (std::size_t k = 0; k < 16; ++k) {
    particles.component(Field::density)[k] = static_cast<double>(k);
    particles.component(Field::velocity_gradient, 1)[k] = static_cast<double>(k);
    order[k] = static_cast<std::int32_t>(15 - k);
  }
  particles.permute(1, order, also);
  return {particles.component(Field::density)[0],
          particles.component(Field::velocity_gradient, 1)[0]};
}

TEST(ParticleBuffersTest, ReSortCarriesStateAndOnlyTheRatesAskedFor) {
  constexpr Field gradient[]{Field::velocity_gradient};
  EXPECT_EQ(after_reversal({}), (std::array{15.0, 0.0}));
  EXPECT_EQ(after_reversal(gradient), (std::array{15.0, 15.0}));
}

}  // namespace
}  // namespace scarp::test
