// SPDX-License-Identifier: BSD-3-Clause
/// Both integrators on a lone grain, whose motion has a closed form, and the waves of a lattice.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/integrate/lattice_sums.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "engine/simulation.hpp"
#include "kernels/smoothing/list.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr double dx = 0.1, gravity = -9.81;
const Vec3 speed{3.0, 4.0, 0.0};

Scene lone_grain(const std::string& preset_name, double duration, double damping = 0.0) {
  Scene scene = elastic_column(preset_name, 1.0, dx);
  scene.walls.clear();
  scene.bodies = {{.shape = Box{{0, 0, 0}, {dx, dx, 0}}, .velocity = speed}};
  scene.stages = {stage_for("fly", duration)};
  scene.stages[0].damping = damping;
  return scene;
}

class IntegratorTest : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Presets, IntegratorTest, testing::Values("paper", "modern"));

TEST_P(IntegratorTest, FlightIsAParabolaWhateverTheSteps) {
  Simulation simulation(lone_grain(GetParam(), 100.0));
  const std::vector<double> start = simulation.field("position");
  int steps = 0;
  for (const double factor : {1.0, 0.37, 0.9, 0.11, 0.6}) {
    simulation.set_step_factor(factor);
    for (int k = 0; k < 50; ++k, ++steps) simulation.step();
    const double t = simulation.last_step().time;
    const std::vector<double> x = simulation.field("position"), v = simulation.field("velocity");
    // Sums of round-off: eps of places of 1 m and speeds of 5 m/s for each step.
    const double rounding = 2.3e-16 * steps;
    EXPECT_NEAR(v[0], speed[0], 5 * rounding);
    EXPECT_NEAR(v[1], speed[1] + gravity * t, 5 * rounding);
    EXPECT_NEAR(x[0], start[0] + speed[0] * t, 2 * rounding);
    EXPECT_NEAR(x[1], start[1] + speed[1] * t + 0.5 * gravity * t * t, 2 * rounding);
    EXPECT_EQ(simulation.field("stress"), std::vector<double>(6, 0.0));
  }
}

TEST_P(IntegratorTest, StageEndsAtItsTimeAndStepsGrowByATenthAtMost) {
  Simulation simulation(lone_grain(GetParam(), 0.01));
  simulation.set_step_factor(0.01);
  double time = 0.0, last = 0.0;
  bool grew = false;
  while (!simulation.finished()) {
    const StepReport& report = simulation.step();
    if (report.step > 5) simulation.set_step_factor(1.0);
    time += report.time_step;
    if (last > 0.0) {
      EXPECT_LE(report.time_step, 1.1 * last * (1.0 + 1e-15));
    }
    grew |= report.limit == StepLimit::growth;
    last = report.time_step;
  }
  EXPECT_TRUE(grew);
  EXPECT_EQ(simulation.last_step().limit, StepLimit::stage_end);
  EXPECT_NEAR(time, 0.01, 1e-17 * static_cast<double>(simulation.last_step().step));
  EXPECT_DOUBLE_EQ(simulation.last_step().time, 0.01);
}

/// A sound wave alone bounds the step: h/c times the CFL number, with c of the elastic constants.
TEST_P(IntegratorTest, TheStepOfALoneGrainIsThatOfSound) {
  const Scene scene = lone_grain(GetParam(), 1.0);
  Simulation simulation(scene);
  const double E = 10e6, nu = 0.3;
  const double sound = std::sqrt(E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / 2000.0);
  EXPECT_NEAR(simulation.step().time_step, scene.numerics.cfl * 1.2 * dx / sound, 1e-15);
  EXPECT_EQ(simulation.last_step().limit, StepLimit::acoustic);
}

/// A force bounds it by sqrt(h/a): gravity and drag beside whatever the pairs do.
TEST_P(IntegratorTest, TheStepOfAGrainInStrongGravityIsThatOfItsForce) {
  constexpr double drag = 1e5, strong = -1e6;  // [1/s], [m/s2]; h/c is 4 times sqrt(h/a)
  Scene scene = lone_grain(GetParam(), 1.0, drag);
  scene.gravity = {0.0, strong, 0.0};
  Simulation simulation(scene);
  const double acceleration = std::hypot(-drag * speed[0], strong - drag * speed[1]);
  const double step = scene.numerics.cfl * std::sqrt(smoothing_ratio_of(scene) * dx / acceleration);
  EXPECT_NEAR(simulation.step().time_step, step, 1e-15);
  EXPECT_EQ(simulation.last_step().limit, StepLimit::force);
}

/// Each half kick takes v to keep v + gain g, the damping on the mean of old and new velocity; its
/// fixed point is g/c at any step.
TEST(KickDriftKickTest, DampingFollowsItsRecurrence) {
  constexpr double c = 60.0;
  Simulation simulation(lone_grain("modern", 10.0, c));
  for (int k = 1; k <= 200; ++k) {
    simulation.step();
    const double d = 0.25 * c * simulation.last_step().time_step;
    const double share = std::pow((1 - d) / (1 + d), 2 * k);
    const std::vector<double> v = simulation.field("velocity");
    EXPECT_NEAR(v[0], speed[0] * share, 1e-14 * k);
    EXPECT_NEAR(v[1], gravity / c + (speed[1] - gravity / c) * share, 1e-14 * k);
  }
}

/// M - 1 leaps from n-1 over two steps after each forward step (E28, E29), the damping on the mean
/// of base and new velocity.
TEST(VerletTest, DampedLeapsAndRestartsFollowTheirRecurrence) {
  constexpr double c = 60.0;
  for (const int interval : {1, 2, 5, 40}) {
    Scene scene = lone_grain("paper", 10.0, c);
    scene.numerics.verlet_restart_interval = interval;
    Simulation simulation(scene);
    double before = 0.0, now = speed[1];
    for (int k = 0; k < 100; ++k) {
      simulation.step();
      const double dt = simulation.last_step().time_step;
      const bool leaps = k % interval != 0;
      const double base = leaps ? before : now, span = leaps ? 2 * dt : dt, d = 0.5 * c * span;
      before = now;
      now = ((1 - d) * base + span * gravity) / (1 + d);
      EXPECT_NEAR(simulation.field("velocity")[1], now, 1e-14 * (k + 1)) << interval;
    }
  }
}

/// The table of THEORY.md, section 2. Equation: K2.
TEST(LatticeSumsTest, MomentsAreThoseOfTheTable) {
  struct Row {
    SmoothingFunction smoothing;
    double ratio, plane, space;
  };
  for (const Row& row : {Row{SmoothingFunction::yang_liu, 1.2, 0.9452, 0.9624},
                         Row{SmoothingFunction::yang_liu, 1.3, 0.9740, 0.9787},
                         Row{SmoothingFunction::yang_liu, 1.5, 0.9833, 0.9995},
                         Row{SmoothingFunction::cubic_spline, 1.2, 0.9908, 0.9817},
                         Row{SmoothingFunction::cubic_spline, 1.25, 1.0010, 0.9819},
                         Row{SmoothingFunction::wendland_c2, 1.2, 0.9638, 0.9852},
                         Row{SmoothingFunction::wendland_c2, 1.5, 0.9974, 1.0006},
                         Row{SmoothingFunction::wendland_c2, 1.6, 0.9958, 0.9999}}) {
    const auto& form = kernels::smoothing_functions[static_cast<std::size_t>(row.smoothing)];
    EXPECT_NEAR(lattice_sums(form, row.ratio, 2).moment, row.plane, 5e-5);
    EXPECT_NEAR(lattice_sums(form, row.ratio, 3).moment, row.space, 5e-5);
  }
}

/// With support below two spacings only the four nearest count, and the sums have closed forms: at
/// the wave number k per spacing along an axis -2 V W' sin k, -2 V W' (1 - cos k)/r, largest at
/// pi/2 and pi; along the diagonal the gradient is sqrt 2 times as large. Equation: T1.
TEST(LatticeSumsTest, FourNeighboursHaveClosedForms) {
  constexpr double ratio = 0.65;  // 2h = 1.3 spacings: diagonals at 1.41 are out of reach
  const auto& form =
      kernels::smoothing_functions[static_cast<std::size_t>(SmoothingFunction::cubic_spline)];
  const LatticeSums sums = lattice_sums(form, ratio, 2);
  const double r = 1.0 / ratio;  // in h
  const double volume = 10.0 / (7.0 * std::acos(-1.0)) / (ratio * ratio);
  const double steep = volume * 0.75 * (2.0 - r) * (2.0 - r);  // -V W'(r) h
  EXPECT_NEAR(sums.moment, 2.0 * steep * r, 1e-14);
  EXPECT_NEAR(sums.wave_number, 2.0 * std::sqrt(2.0) * steep, 1e-14);
  EXPECT_NEAR(sums.damping[static_cast<std::size_t>(kernels::Term::viscosity)], 4.0 * steep / r,
              1e-14);
  EXPECT_NEAR(sums.damping[static_cast<std::size_t>(kernels::Term::diffusion)], 16.0 * steep / r,
              1e-13);
}

}  // namespace
}  // namespace scarp::test
