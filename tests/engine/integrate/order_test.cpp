// SPDX-License-Identifier: BSD-3-Clause
/// Order in time of both integrators, against a standing wave of the lattice.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/scene/smoothing_choice.hpp"
#include "engine/simulation.hpp"
#include "kernels/smoothing/list.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double dx = 0.1, youngs = 10e6, poisson = 0.3, density = 2000.0;
/// So small that what is quadratic in the strain, 1e-7, is below all that is looked at.
constexpr double speed = 1e-5;

/// An elastic bar of 1 m between smooth walls, started with the speed sin(pi x/L) along itself:
/// mirror images make it an endless lattice, of which that is a wave. No term that damps.
Scene standing_wave(Integrator integrator) {
  Scene scene = elastic_column("modern", 0.4, dx);
  scene.gravity = {};
  scene.numerics.integrator = integrator;
  scene.numerics.viscosity_alpha = 0.0;
  scene.walls = {wall_of("box", WallKind::free_slip,
                         {facet_2d(0, 0, 1, 0), facet_2d(1, 0, 1, 0.4), facet_2d(1, 0.4, 0, 0.4),
                          facet_2d(0, 0.4, 0, 0)})};
  scene.bodies[0].velocity_field = {"1e-5 * sin(3.14159265358979323846 * x)", "0"};
  scene.stages = {stage_for("swing", 100.0)};
  return scene;
}

/// Circular frequency of that wave: the sound speed times -1/M sum V W' (x/r) sin(k x) over the
/// lattice, for the velocity gradient and for the force alike. Equation: K2, T1.
double frequency(const Scene& scene) {
  const auto& form = smoothing_of(scene);
  const double ratio = smoothing_ratio_of(scene);
  double wave = 0.0, moment = 0.0;
  for (int i = -3; i <= 3; ++i) {
    for (int j = -3; j <= 3; ++j) {
      const double r = std::hypot(i, j);
      if (r == 0.0 || r >= 2.0 * ratio) continue;
      wave -= form.slope(r / ratio) * (i / r) * std::sin(pi * dx * i);
      moment -= form.slope(r / ratio) * (i / r) * i * dx;
    }
  }
  const double modulus = youngs * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson));
  return std::sqrt(modulus / density) * wave / moment;
}

/// Amplitude of the displacement over U/omega, when it was sin(omega t) in truth; and the truth.
struct Swing {
  double found, truth, step;
};

Swing swing(const Scene& scene, double factor, int steps) {
  Simulation simulation(scene, {1, {}});
  simulation.set_step_factor(factor);
  for (int k = 0; k < steps; ++k) simulation.step();
  const double omega = frequency(scene), time = simulation.last_step().time;
  const std::vector<double> moved = simulation.field("displacement"),
                            place = simulation.field("position");
  double share = 0.0, norm = 0.0;
  for (std::size_t k = 0; k < moved.size(); k += 3) {
    const double form = std::sin(pi * place[k]);
    share += form * moved[k];
    norm += form * form;
  }
  return {share / norm * omega / speed, std::sin(omega * time), omega * time / steps};
}

double error(const Scene& scene, double factor, int steps) {
  const Swing result = swing(scene, factor, steps);
  return std::abs(result.found - result.truth);
}

/// Orders from three step sizes over the same time.
std::vector<double> orders(const Scene& scene, int steps) {
  const double coarse = error(scene, 1.0, steps), middle = error(scene, 0.5, 2 * steps),
               fine = error(scene, 0.25, 4 * steps);
  return {std::log2(coarse / middle), std::log2(middle / fine)};
}

/// Its swing is that of the leapfrog: omega dt sin(n theta)/sin(theta) with
/// sin(theta/2) = omega dt/2, which lags by omega t (omega dt)^2/24.
TEST(OrderTest, KickDriftKickIsOfSecondOrder) {
  const Scene scene = standing_wave(Integrator::kick_drift_kick);
  constexpr int steps = 10;  // about 0.6 of a period
  for (const double factor : {1.0, 0.5, 0.25}) {
    const int n = static_cast<int>(steps / factor);
    const Swing result = swing(scene, factor, n);
    const double theta = 2.0 * std::asin(0.5 * result.step);
    EXPECT_NEAR(result.found, result.step * std::sin(n * theta) / std::sin(theta), 1e-6);
  }
  // The next term of the error is (omega dt)^2, 0.14 at the coarsest, times less than a third.
  const std::vector<double> found = orders(scene, steps);
  EXPECT_NEAR(found[0], 2.0, 0.07);
  EXPECT_NEAR(found[1], 2.0, 0.02);
}

/// Leaps from n-1 are of second order, with a next term of the error of (omega dt)^2 = 0.005 at the
/// coarsest; forward steps (M = 1) of first, with one of omega dt = 0.07 and half of that.
TEST(OrderTest, VerletIsOfSecondOrderWhereItLeapsAndOfFirstWhereItDoesNot) {
  Scene scene = standing_wave(Integrator::verlet);
  scene.numerics.cfl = 0.2;
  constexpr int steps = 50;  // about 0.6 of a period
  scene.numerics.verlet_restart_interval = 100 * steps;
  const std::vector<double> leaps = orders(scene, steps);
  EXPECT_NEAR(leaps[0], 2.0, 0.01);
  EXPECT_NEAR(leaps[1], 2.0, 0.0025);
  scene.numerics.verlet_restart_interval = 1;
  const std::vector<double> forward = orders(scene, steps);
  EXPECT_NEAR(forward[0], 1.0, 0.05);
  EXPECT_NEAR(forward[1], 1.0, 0.025);
}

}  // namespace
}  // namespace scarp::test
