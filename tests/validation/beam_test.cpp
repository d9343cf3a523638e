// SPDX-License-Identifier: BSD-3-Clause
/// Closed forms of the case beam.
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "validation/cases/beam/modes.hpp"

namespace scarp::validation {
namespace {

double slope(const BendingMode& mode, double x) {
  return (mode.deflection(x + 1e-4) - mode.deflection(x - 1e-4)) / 2e-4;
}
double curvature(const BendingMode& mode, double x) {
  return (mode.rotation(x + 1e-4) - mode.rotation(x - 1e-4)) / 2e-4;
}

TEST(BendingModeTest, SlenderBeamsAreThoseOfEulerAndBernoulli) {
  // Shear and rotary inertia lower the frequency by about (k L)^2 (D/L)^2/24 (1 + E'/(kappa G)),
  // 4e-4 here.
  const Beam beam(100.0, 1.0, 1.0, 1.0, 0.3);
  const BendingMode free(beam, Support::free_free), clamped(beam, Support::clamped_free);
  EXPECT_NEAR(free.frequency() / beam.slender_frequency(4.730041), 1.0, 1e-3);
  EXPECT_NEAR(clamped.frequency() / beam.slender_frequency(1.875104), 1.0, 1e-3);
  // Middle over end of the free beam's first mode, tables of Blevins: -0.6078.
  EXPECT_NEAR(free.deflection(0.0), -0.6078, 1e-3);
}

TEST(BendingModeTest, AFreeBeamOfTenDepthsIsThatOfPlaneElasticity) {
  // Rayleigh and Ritz with polynomials up to degree 16 along and 7 across the beam; up to 12 and 5
  // the number is the same to 1e-6. Timoshenko's theory leaves out terms of (k D)^4 times 1e-3.
  const BendingMode mode(Beam(10.0, 1.0, 1.0, 1.0, 0.3), Support::free_free);
  EXPECT_NEAR(mode.frequency() / 0.0653503, 1.0, 1e-4);
}

TEST(BendingModeTest, EndsAreFreeOrClamped) {
  const Beam beam(5.0, 1.0, 1000.0, 1e7, 0.3);
  const BendingMode free(beam, Support::free_free), clamped(beam, Support::clamped_free);
  for (const auto& [mode, end] : {std::pair{free, 2.5}, std::pair{clamped, 5.0}}) {
    EXPECT_NEAR(mode.deflection(end), 1.0, 1e-9);
    // Against slopes and curvatures of about 1; difference quotients err by 1e-8.
    EXPECT_NEAR(curvature(mode, end), 0.0, 1e-6);
    EXPECT_NEAR(slope(mode, end) - mode.rotation(end), 0.0, 1e-6);
  }
  EXPECT_NEAR(clamped.deflection(0.0), 0.0, 1e-12);
  EXPECT_NEAR(clamped.rotation(0.0), 0.0, 1e-12);
  EXPECT_NEAR(free.rotation(0.0), 0.0, 1e-12);
}

TEST(BeamTest, SagIsThatOfBendingAndShear) {
  const Beam beam(5.0, 1.0, 2.0, 10.0, 0.0);  // E' = 10, G = 5, kappa = 5/6, I = 1/12
  EXPECT_NEAR(beam.sag(1.0, 5.0),
              2.0 * 625.0 / (8.0 * 10.0 / 12.0) + 2.0 * 25.0 / (2.0 * 25.0 / 6.0), 1e-9);
  EXPECT_EQ(beam.sag(1.0, 0.0), 0.0);
}

}  // namespace
}  // namespace scarp::validation
