// SPDX-License-Identifier: BSD-3-Clause
/// A few grains through a whole step of Verlet, against the equations summed by hand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/simulation.hpp"
#include "kernels/isa/kernel_table.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr double dx = 0.1, h = 1.2 * dx, youngs_modulus = 10e6, poisson = 0.3, rho = 2000.0;
constexpr double bulk = youngs_modulus / (3.0 * (1.0 - 2.0 * poisson));
constexpr double shear = youngs_modulus / (2.0 * (1.0 + poisson));
const double sound = std::sqrt((bulk + 4.0 / 3.0 * shear) / rho);
using Matrix = std::array<std::array<double, 3>, 3>;

/// dW/dr of the cubic spline. Source: Monaghan and Lattanzio (1985), its pieces differentiated.
double slope(double r, int dimension) {
  const double q = r / h, pi = std::numbers::pi;
  const double scale = dimension == 2 ? 10.0 / (7.0 * pi * h * h * h) : 1.0 / (pi * h * h * h * h);
  if (q < 1.0) return scale * (-3.0 * q + 2.25 * q * q);
  return q < 2.0 ? -0.75 * scale * (2.0 - q) * (2.0 - q) : 0.0;
}

/// Grains of one particle each, on places of the lattice, without terms that are asked for apart.
Scene grains(int dimension, const std::vector<Vec3>& cells, const std::vector<Vec3>& velocities) {
  Scene scene = elastic_column("paper", 1.0, dx);
  scene.dimension = dimension;
  scene.walls.clear();
  scene.bodies.resize(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const Vec3& c = cells[k];
    const Box box{{c[0] * dx, c[1] * dx, dimension == 3 ? c[2] * dx : 0.0},
                  {(c[0] + 1) * dx, (c[1] + 1) * dx, dimension == 3 ? (c[2] + 1) * dx : 0.0}};
    scene.bodies[k].shape = box;
    scene.bodies[k].velocity = velocities[k];
  }
  scene.numerics.smoothing = SmoothingFunction::cubic_spline;
  scene.numerics.viscosity_alpha = 0.0;
  scene.numerics.artificial_stress = 0.0;
  scene.gravity = {1.0, -2.0, dimension == 3 ? 0.5 : 0.0};
  scene.stages = {stage_for("fly", 1.0)};
  return scene;
}

std::vector<Vec3> vectors(const Simulation& simulation, const char* field) {
  const std::vector<double> values = simulation.field(field);
  std::vector<Vec3> out(values.size() / 3);
  for (std::size_t k = 0; k < values.size(); ++k) out[k / 3][k % 3] = values[k];
  return out;
}

Matrix tensor(const std::vector<double>& s, std::size_t k) {
  const double* v = s.data() + 6 * k;
  return {{{v[0], v[3], v[5]}, {v[3], v[1], v[4]}, {v[5], v[4], v[2]}}};
}

/// Every sum over the other grains at the start. Equations: E19, E20, E23, E24, E26.
struct Sums {
  double density_rate = 0.0;
  Matrix gradient{};
  Vec3 acceleration{};
};
Sums sums_at(std::size_t i, const Scene& scene, const std::vector<Vec3>& x,
             const std::vector<Vec3>& v) {
  const int d = scene.dimension;
  const double mass = rho * std::pow(dx, d);
  const auto& s = scene.uniform_stress;
  const Matrix stress{{{s[0], s[3], s[5]}, {s[3], s[1], s[4]}, {s[5], s[4], s[2]}}};
  Sums sums;
  sums.acceleration = scene.gravity;
  for (std::size_t j = 0; j < x.size(); ++j) {
    if (j == i) continue;
    Vec3 apart{}, grad{};
    double r2 = 0.0, approach = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      apart[a] = x[i][a] - x[j][a];
      r2 += apart[a] * apart[a];
      approach += apart[a] * (v[i][a] - v[j][a]);
    }
    const double r = std::sqrt(r2);
    for (std::size_t a = 0; a < 3; ++a) grad[a] = slope(r, d) * apart[a] / r;
    const double mu = approach < 0.0 ? h * approach / (r2 + 0.01 * h * h) : 0.0;
    const double pi =
        (-scene.numerics.viscosity_alpha * sound * mu + scene.numerics.viscosity_beta * mu * mu) /
        rho;
    for (std::size_t a = 0; a < 3; ++a) {
      sums.density_rate += mass * (v[i][a] - v[j][a]) * grad[a];
      sums.acceleration[a] -= mass * pi * grad[a];
      for (std::size_t b = 0; b < 3; ++b) {
        sums.gradient[a][b] += mass / rho * (v[j][a] - v[i][a]) * grad[b];
        sums.acceleration[a] += mass * 2.0 * stress[a][b] / (rho * rho) * grad[b];
      }
    }
  }
  return sums;
}

/// s + dt (w s - s w + 2 G dev e + K tr e I). Equations: E15 to E18.
Matrix stressed(const Matrix& s, const Matrix& gradient, double dt) {
  Matrix out = s;
  double trace = 0.0;
  for (std::size_t a = 0; a < 3; ++a) trace += gradient[a][a];
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = 0; b < 3; ++b) {
      double rate = shear * (gradient[a][b] + gradient[b][a]);
      if (a == b) rate += (bulk - 2.0 / 3.0 * shear) * trace;
      for (std::size_t c = 0; c < 3; ++c) {
        rate += 0.5 * (gradient[a][c] - gradient[c][a]) * s[c][b] -
                0.5 * s[a][c] * (gradient[c][b] - gradient[b][c]);
      }
      out[a][b] += dt * rate;
    }
  }
  return out;
}

/// Four terms a sum in double: 1e-12 of the largest of what is compared. In mixed precision records
/// carry 2^-24 and positions 2^-19 h, which over slopes of 4/h make 1e-5 of a sum.
void expect_one_step(Scene scene, const RunOptions& options) {
  const bool mixed = scene.numerics.precision == Precision::mixed;
  const double of_sums = mixed ? 1e-5 : 1e-12;
  Simulation simulation(scene, options);
  const std::vector<Vec3> x = vectors(simulation, "position"), v = vectors(simulation, "velocity");
  const std::vector<double> start = simulation.field("stress");
  simulation.step();
  const double dt = simulation.last_step().time_step;
  ASSERT_GT(dt, 0.0);
  const std::vector<Vec3> x1 = vectors(simulation, "position");
  const std::vector<Vec3> v1 = vectors(simulation, "velocity");
  const std::vector<double> density = simulation.field("density"), end = simulation.field("stress");
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Sums sums = sums_at(i, scene, x, v);
    // Densities of 2000 change by rates of 1e5 kg/m3/s, speeds of 1 by 1e3 m/s2.
    EXPECT_NEAR(density[i], rho + dt * sums.density_rate, rho * 1e-12 + dt * 1e5 * of_sums);
    const Matrix expected = stressed(tensor(start, i), sums.gradient, dt), got = tensor(end, i);
    for (std::size_t a = 0; a < 3; ++a) {
      EXPECT_NEAR(v1[i][a], v[i][a] + dt * sums.acceleration[a], 1e-12 + dt * 1e3 * of_sums);
      EXPECT_NEAR(x1[i][a], x[i][a] + dt * (v[i][a] + 0.5 * dt * sums.acceleration[a]),
                  1e-14 + dt * dt * 1e3 * of_sums);
      for (std::size_t b = 0; b < 3; ++b) {
        EXPECT_NEAR(got[a][b], expected[a][b], 1e5 * 1e-12 + dt * bulk * 50.0 * of_sums)
            << i << " " << a << b;
      }
    }
  }
}

const std::vector<Vec3> places_2d{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 1, 0}};
const std::vector<Vec3> places_3d{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
const std::vector<Vec3> speeds_2d{
    {0.3, -0.7, 0.0}, {-0.5, 0.2, 0.0}, {0.9, 0.4, 0.0}, {-0.2, -0.6, 0.0}};
const std::vector<Vec3> speeds_3d{
    {0.3, -0.7, 0.1}, {-0.5, 0.2, 0.8}, {0.9, 0.4, -0.3}, {-0.2, -0.6, 0.5}, {0.1, 0.0, -0.4}};

Scene moving(int dimension) {
  return dimension == 2 ? grains(2, places_2d, speeds_2d) : grains(3, places_3d, speeds_3d);
}
Scene pressed(Scene scene) {
  scene.initial_stress = InitialStress::uniform;
  scene.uniform_stress = {-3e4, -5e4, -2e4, 1e4, 0.0, 0.0};
  if (scene.dimension == 3) scene.uniform_stress = {-3e4, -5e4, -2e4, 1e4, -0.7e4, 0.4e4};
  return scene;
}

template <class Change>
void on_every_machine(Change&& change) {
  for (const int dimension : {2, 3}) {
    for (const Precision precision : {Precision::real64, Precision::mixed}) {
      for (const kernels::Isa isa : kernels::available_isas()) {
        RunOptions options;
        options.isa = kernels::kernels_of(isa).name;
        SCOPED_TRACE(options.isa + (precision == Precision::mixed ? " mixed " : " double ") +
                     std::to_string(dimension));
        Scene scene = change(moving(dimension));
        scene.numerics.precision = precision;
        expect_one_step(scene, options);
      }
    }
  }
}

TEST(GrainsTest, MotionChangesDensityAndStress) {
  on_every_machine([](Scene scene) { return scene; });
}

TEST(GrainsTest, StressAcceleratesAndTurns) { on_every_machine(pressed); }

TEST(GrainsTest, ViscosityResistsApproachAlone) {
  on_every_machine([](Scene scene) {
    scene.numerics.viscosity_alpha = 0.7;
    scene.numerics.viscosity_beta = 1.5;
    return scene;
  });
}

TEST(GrainsTest, NoGrainFeelsOneBeyondItsSupport) {
  // 2.4 dx is the support: three spacings apart nothing acts, two spacings apart something does.
  for (const double cells : {2.0, 3.0}) {
    const Scene scene = pressed(grains(2, {{0, 0, 0}, {cells, 0, 0}}, {{1, 0, 0}, {-1, 0, 0}}));
    expect_one_step(scene, {});
    Simulation simulation(scene);
    simulation.step();
    EXPECT_EQ(simulation.field("density")[0] != rho, cells == 2.0);
  }
}

/// Uniform tension s at the distance dx, where F = W(r)/W(dx) = 1 whatever the exponent: the pair
/// pushes itself apart by 2 epsilon s/rho^2. Equation: E27.
TEST(GrainsTest, ArtificialStressTakesItsShareOfTheTension) {
  constexpr double tension = 4e4, epsilon = 0.3;
  for (const double exponent : {2.55, 4.0}) {
    Scene scene = grains(2, {{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}});
    scene.gravity = {0, 0, 0};
    scene.initial_stress = InitialStress::uniform;
    scene.uniform_stress = {tension, tension, tension, 0, 0, 0};
    scene.numerics.artificial_stress = epsilon;
    scene.numerics.artificial_stress_exponent = exponent;
    Simulation simulation(scene);
    simulation.step();
    const double pull = 2.0 * dx * dx * tension / rho * -slope(dx, 2);  // towards the other
    const double v = vectors(simulation, "velocity")[0][0];
    // F^n is fitted: at n = 4 to 2e-4 for the cubic spline, at 2.55 to 6e-6.
    EXPECT_NEAR(v, simulation.last_step().time_step * (1.0 - epsilon) * pull,
                simulation.last_step().time_step * epsilon * pull * 2e-4);
  }
}

}  // namespace
}  // namespace scarp::test
