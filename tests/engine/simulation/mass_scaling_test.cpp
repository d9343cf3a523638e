// SPDX-License-Identifier: BSD-3-Clause
/// Inertia that is not mass: the same run more slowly, other densities, and the same rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/errors.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// Speeds and rates of a scene halved, times doubled, and inertia four times as much: powers of
/// two, so that every number of the run is the same but for its exponent.
Scene slowed(Scene scene) {
  for (Material& material : scene.materials) material.mass_scaling = 4.0;
  for (Body& body : scene.bodies) {
    for (double& v : body.velocity) v *= 0.5;
  }
  for (Wall& wall : scene.walls) {
    for (double& v : wall.velocity) v *= 0.5;
  }
  for (Stage& stage : scene.stages) {
    if (stage.duration) *stage.duration *= 2.0;
    if (stage.damping) *stage.damping *= 0.5;
    stage.rest_velocity *= 0.5;
  }
  return scene;
}

/// In 2D and 3D, with walls of both kinds that move and are removed, soil that yields and flows,
/// images under oblique gravity, settling, viscosity of all kinds, sleep, mixed precision.
std::vector<std::pair<std::string, Scene>> scenes() {
  std::vector<std::pair<std::string, Scene>> all;
  const auto add = [&all](const std::string& name, Scene scene) -> Scene& {
    scene.numerics.artificial_stress = 0.0;
    scene.output.energy = true;
    return all.emplace_back(name, std::move(scene)).second;
  };
  for (const std::string name : {"paper", "modern"}) {
    for (const Integrator integrator : {Integrator::verlet, Integrator::kick_drift_kick}) {
      const std::string both =
          name + (integrator == Integrator::verlet ? " verlet " : " kick_drift_kick ");
      const auto with = [&](const std::string& what, Scene scene) -> Scene& {
        Scene& added = add(both + what, std::move(scene));
        added.numerics.integrator = integrator;
        if (integrator == Integrator::verlet) added.numerics.cfl = 0.2;
        return added;
      };
      with("slope", small_slope(name, 0.05, 10.0, 2.0));
      with("bed", bed_and_grain(name)).gravity = {3.0, -9.0, 0.0};
      Scene& collapse = with("collapse", small_collapse(name, 0.02, 10.0));
      collapse.stages[0].duration = 2e-3;
      collapse.walls[0].velocity = {0.3, 0.0, 0.05};
      Scene& settles = with("settles", small_slope(name, 10.0, 10.0, 2.0));
      settles.stages[0].until = StageEnd::rest;
      settles.stages[0].rest_velocity = 1.0;
      settles.stages[0].damping = 10.0;  // that of its own is rounded otherwise
      settles.numerics.hourglass_viscosity = 0.1;
      settles.numerics.viscosity_beta = 1.0;
    }
  }
  Scene& mixed = add("mixed precision", bed_and_grain("modern"));
  mixed.numerics.precision = Precision::mixed;
  Scene& sleeps = add("sleep", bed_and_grain("modern"));
  sleeps.numerics.sleep = 0.5;
  return all;
}

TEST(MassScalingTest, FourTimesTheInertiaIsTheSameRunAtHalfTheSpeedToTheLastBit) {
  for (const auto& [name, scene] : scenes()) {
    Simulation plain(scene, {1, {}}), slow(slowed(scene), {1, {}});
    for (int k = 0; k < 200; ++k) {
      plain.step();
      slow.step();
    }
    SCOPED_TRACE(name);
    EXPECT_EQ(slow.last_step().time, 2.0 * plain.last_step().time);
    EXPECT_EQ(slow.last_step().limit, plain.last_step().limit);
    EXPECT_EQ(slow.stage_index(), plain.stage_index());
    for (const char* field : {"position", "stress", "density"})
      EXPECT_EQ(slow.field(field), plain.field(field)) << field;
    std::vector<double> twice = slow.field("velocity");
    for (double& v : twice) v *= 2.0;
    EXPECT_EQ(twice, plain.field("velocity"));
    const EnergyBalance a = slow.energy(), b = plain.energy();
    for (const auto part :
         {&EnergyBalance::kinetic, &EnergyBalance::potential, &EnergyBalance::elastic,
          &EnergyBalance::plastic, &EnergyBalance::viscous, &EnergyBalance::damping,
          &EnergyBalance::wall, &EnergyBalance::diffusion, &EnergyBalance::imbalance})
      EXPECT_EQ(a.*part, b.*part);
    EXPECT_NEAR(a.kinetic_added / a.kinetic, 0.75, 1e-12);  // 3 m v^2, summed
    const std::vector<WallReaction> of_slow = slow.wall_reactions(),
                                    of_plain = plain.wall_reactions();
    for (std::size_t w = 0; w < of_plain.size(); ++w)
      EXPECT_EQ(of_slow[w].force, of_plain[w].force);
    EXPECT_EQ(slow.asleep_count(), plain.asleep_count());
  }
}

/// Two blocks without weight, the heavy one thrown at the other from beyond its reach.
Scene blocks(double density, double scaling) {
  Scene scene = elastic_column("modern", 1.0, 0.1);
  scene.walls.clear();
  scene.gravity = {};
  scene.materials.push_back(elastic(10e6));
  scene.materials[1].name = "heavy";
  scene.materials[1].density = density;
  scene.materials[1].mass_scaling = scaling;
  scene.bodies = {{.shape = Box{{0, 0, 0}, {1, 1, 0}}, .material = "elastic"},
                  {.shape = Box{{1.3, 0.3, 0}, {2.3, 1.3, 0}},
                   .material = "heavy",
                   .velocity = {-2.0, 0.8, 0.0}}};
  scene.initial_stress = InitialStress::zero;
  scene.stages = {stage_for("meet", 10.0)};
  scene.numerics.hourglass_viscosity = 0.1;
  scene.numerics.viscosity_beta = 1.0;
  return scene;
}

TEST(MassScalingTest, WithoutWeightItIsADensityToTheLastBit) {
  for (const Integrator integrator : {Integrator::verlet, Integrator::kick_drift_kick}) {
    for (const Precision precision : {Precision::real64, Precision::mixed}) {
      Scene dense = blocks(64.0 * 2000.0, 1.0), scaled = blocks(2000.0, 64.0);
      for (Scene* scene : {&dense, &scaled}) {
        scene->numerics.integrator = integrator;
        scene->numerics.precision = precision;
        if (integrator == Integrator::verlet) scene->numerics.cfl = 0.2;
      }
      const Simulation a = run_steps(dense, 400), b = run_steps(scaled, 400);
      for (const char* field : {"position", "velocity", "stress"})
        EXPECT_EQ(a.field(field), b.field(field)) << field;
    }
  }
}

TEST(MassScalingTest, MomentumIsThatOfTheInertia) {
  Simulation simulation = run_steps(blocks(2000.0, 50.0), 400);
  const auto velocity = simulation.field("velocity"), position = simulation.field("position"),
             material = simulation.field("material");
  Vec3 sum{};
  double all = 0.0, turn = 0.0, slowest = 2.0;
  for (std::size_t k = 0; k < material.size(); ++k) {
    const double inertia = material[k] == 1.0 ? 50.0 : 1.0;
    all += inertia;
    for (std::size_t a = 0; a < 2; ++a) sum[a] += inertia * velocity[3 * k + a];
    turn +=
        inertia * (position[3 * k] * velocity[3 * k + 1] - position[3 * k + 1] * velocity[3 * k]);
    if (material[k] == 1.0) slowest = std::min(slowest, std::abs(velocity[3 * k]));
  }
  // 100 grains each; the heavy ones started at (-2, 0.8) about (1.8, 0.8).
  const double heavy = 50.0 * 100.0;
  EXPECT_LT(slowest, 1.9);  // they have met
  // Round-off of 400 steps of sums over 20 neighbours.
  EXPECT_NEAR(sum[0] / (-2.0 * heavy), 1.0, 1e-11);
  EXPECT_NEAR(sum[1] / (0.8 * heavy), 1.0, 1e-11);
  EXPECT_NEAR(all, heavy + 100.0, 1e-9);
  // Angular momentum is that of T M - M T^T = 0, M being that of mid-step, turned: second order.
  EXPECT_NEAR(turn / (heavy * (1.8 * 0.8 + 0.8 * 2.0)), 1.0, 1e-4);
}

TEST(MassScalingTest, AFreeBlockFallsMoreSlowly) {
  for (const Integrator integrator : {Integrator::verlet, Integrator::kick_drift_kick}) {
    Scene scene = elastic_column("modern", 0.3, 0.1);
    scene.walls.clear();
    scene.numerics.integrator = integrator;
    scene.materials[0].mass_scaling = 25.0;
    scene.initial_stress = InitialStress::zero;
    scene.stages = {stage_for("fall", 10.0)};
    const Simulation simulation = run_steps(scene, 100);
    const double time = simulation.last_step().time, fallen = -0.5 * 9.81 / 25.0 * time * time;
    const auto displacement = simulation.field("displacement");
    // Both schemes are exact for constant accelerations, to round-off of places of 1 m.
    for (std::size_t k = 1; k < displacement.size(); k += 3)
      EXPECT_NEAR(displacement[k], fallen, 1e-13);
  }
}

/// 1 m of one elastic soil on 1 m of another between smooth sides, at rest under their weight.
Scene layers(double below, double above, double scaling_below, double scaling_above) {
  Scene scene = elastic_column("modern", 2.0, 0.1);
  scene.materials = {elastic(below), elastic(above)};
  scene.materials[0].name = "below";
  scene.materials[1].name = "above";
  scene.materials[0].mass_scaling = scaling_below;
  scene.materials[1].mass_scaling = scaling_above;
  scene.bodies = {{.shape = Box{{0, 0, 0}, {1, 1, 0}}, .material = "below"},
                  {.shape = Box{{0, 1, 0}, {1, 2, 0}}, .material = "above"}};
  scene.stages[0].damping = 90.0;  // near critical for 1 m of the soft soil
  return scene;
}

Simulation settled(Scene scene) {
  Simulation simulation(std::move(scene), {1, {}});
  while (!simulation.finished()) simulation.step();
  EXPECT_TRUE(simulation.stage_reached_rest());
  return simulation;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
  return most;
}

TEST(MassScalingTest, LayersComeToTheSameRest) {
  constexpr double soft = 10e6, stiff = 1e9, contrast = stiff / soft;
  for (const bool stiff_below : {true, false}) {
    const double below = stiff_below ? stiff : soft, above = stiff_below ? soft : stiff;
    const Scene plain = layers(below, above, 1.0, 1.0);
    Scene scaled = layers(below, above, stiff_below ? contrast : 1.0, stiff_below ? 1.0 : contrast);
    if (!stiff_below) scaled.stages[0].damping = 18.0;  // critical for 100 times the mass on it
    const Simulation a = settled(plain), b = settled(scaled);
    EXPECT_NEAR(static_cast<double>(a.last_step().step) / static_cast<double>(b.last_step().step) *
                    b.last_step().time / a.last_step().time,
                10.0, 0.1);
    // What 1e-6 m/s leaves open. Zigzags from row to row do not strain the stiff layer, so that
    // only the soft soil moves its inertia to where it rests: omega^2 = M/(s rho H^2), a way of v
    // c_d/omega^2, and twice of it as both layers have a share. In stress M times that over 1 m.
    const double modulus = soft * 0.7 / (1.3 * 0.4);
    const double way = 2.0 * 1e-6 * 90.0 * contrast * 2000.0 / modulus;
    EXPECT_LT(way, 4e-3 * 2000.0 * 9.81 / (2.0 * modulus));  // of the settlement of the soft soil
    EXPECT_LT(largest_difference(a.field("stress"), b.field("stress")), modulus * way);
    EXPECT_LT(largest_difference(a.field("displacement"), b.field("displacement")), way);
    const std::vector<WallReaction> of_a = a.wall_reactions(), of_b = b.wall_reactions();
    EXPECT_NEAR(of_a[0].force[1], of_b[0].force[1], modulus * way);
  }
}

TEST(MassScalingTest, AContrastOfTenThousandNeedsNoShorterStep) {
  const auto to_rest = [](Scene scene) {
    scene.stages[0].rest_velocity = 1e-5;
    return settled(std::move(scene));
  };
  const Simulation simulation = to_rest(layers(1e11, 10e6, 1e4, 1.0)),
                   soft = to_rest(layers(10e6, 10e6, 1.0, 1.0));
  // The same speed of sound in both, but for the change of density under the weight, 1e-3.
  EXPECT_NEAR(simulation.last_step().time_step / soft.last_step().time_step, 1.0, 2e-3);
  // gamma H^2/(2 M) of the soft layer, to half a spacing below its top; the rest of 1e-4 of it is
  // the stiff one's. 1 %: the band of the oedometer case, and the interface, which is as wide as
  // the support: 2 h/dx of half a spacing's settlement.
  const auto displacement = simulation.field("displacement");
  const double modulus = 10e6 * 0.7 / (1.3 * 0.4), y = 0.95;
  const double expected = 2000.0 * 9.81 / modulus * (y - 0.5 * y * y);
  double lowest = 0.0;
  for (std::size_t k = 1; k < displacement.size(); k += 3)
    lowest = std::min(lowest, displacement[k]);
  EXPECT_NEAR(-lowest / expected, 1.0, 0.03);
}

TEST(MassScalingTest, ThePassageOfAColumnIsThatOfItsFirstMode) {
  // c_d = pi/(2 passage): a slab of 100 times the inertia on soft soil swings at sqrt(k/m), k =
  // M/H and m = 100 rho H, so that passage = H sqrt(2 (100 + 1/2) rho/M), and the slab's own
  // 100/2 (stiffness 10^4 times) adds 1e-4 of it.
  Scene scene = layers(10e6, 1e11, 1.0, 100.0);
  scene.stages[0].damping.reset();
  scene.stages[0].reset_after = true;
  scene.stages.push_back(stage_for("on", 1.0));
  const Simulation simulation = run_steps(scene, 1);
  const double modulus = 10e6 * 0.7 / (1.3 * 0.4);
  const double passage = std::sqrt(2.0 * (100.0 + 0.5) * 2000.0 / modulus);
  const double damping = simulation.snapshot().numbers("stage/damping", 1).front();
  EXPECT_NEAR(damping / (std::numbers::pi / (2.0 * passage)), 1.0, 1e-3);
}

/// A pulse in a bar of soft soil meets soil of 4 times the modulus and 4 times the inertia. With
/// the impedance Z = sqrt(s rho M) four times as much, -0.6 of its momentum comes back and 1.6 go
/// on.
TEST(MassScalingTest, AWaveIsReflectedByTheImpedance) {
  constexpr double dx = 0.05, width = 0.25;
  Scene scene = elastic_column("modern", 0.2, dx);
  scene.gravity = {};
  scene.initial_stress = InitialStress::zero;
  scene.numerics.viscosity_alpha = 0.0;
  scene.materials = {elastic(10e6), elastic(40e6)};
  scene.materials[1].name = "scaled";
  scene.materials[1].mass_scaling = 4.0;
  scene.bodies = {{.shape = Box{{0, 0, 0}, {4, 0.2, 0}}, .material = "elastic"},
                  {.shape = Box{{4, 0, 0}, {8, 0.2, 0}}, .material = "scaled"}};
  scene.bodies[0].velocity_field = {"1e-3 * exp(-((x - 2.5) / 0.25)^2)", "0"};
  scene.walls = {
      wall_of("sides", WallKind::free_slip, {facet_2d(-1, 0, 9, 0), facet_2d(9, 0.2, -1, 0.2)})};
  const double speed = std::sqrt(10e6 * 0.7 / (1.3 * 0.4) / 2000.0);
  scene.stages = {stage_for("travel", 2.5 / speed)};
  Simulation simulation(scene, {1, {}});
  while (!simulation.finished()) simulation.step();
  const auto velocity = simulation.field("velocity"), position = simulation.field("position"),
             material = simulation.field("material");
  double back = 0.0, on = 0.0;
  for (std::size_t k = 0; k < material.size(); ++k) {
    if (material[k] == 1.0) on += 4.0 * velocity[3 * k];
    if (material[k] == 0.0 && position[3 * k] > 1.5) back += velocity[3 * k];
  }
  // Half of the pulse goes to the right; four rows.
  const double coming = 4.0 * 0.5 * 1e-3 * width * std::sqrt(std::numbers::pi) / dx;
  // The interface is blurred over h = 0.24 of the width, its square times a slope of order 1/4.
  EXPECT_NEAR(back / coming, -0.6, 0.015);
  EXPECT_NEAR(on / coming, 1.6, 0.015);
}

TEST(MassScalingTest, SoilThatComesToTouchAScaledPartStopsTheRunWithTheReason) {
  Scene scene = layers(1e11, 10e6, 1e4, 1.0);
  scene.bodies[1].shape = Box{{0, 1.3, 0}, {1, 2, 0}};  // beyond the reach of 0.24 m
  scene.bodies[1].velocity = {0.0, -5.0, 0.0};
  scene.stages[0].damping = 0.0;
  try {
    run_steps(scene, 1000);
    ADD_FAILURE() << "it bore the step";
  } catch (const SimulationInstability& instability) {
    EXPECT_EQ(instability.what_happened()->field, "inertia over mass") << instability.what();
  }
}

TEST(MassScalingTest, TheBalanceOfEnergyCloses) {
  Scene scene = small_slope("modern", 0.5, 1.5, 2.0);
  scene.materials.push_back(elastic(1e9));
  scene.materials[1].mass_scaling = 30.0;
  scene.bodies.push_back({.shape = Box{{0, 0, 0}, {45, 2, 0}}, .material = "elastic"});
  scene.bodies[0].material = "clay";
  scene.bodies[0].shape = Polygon{{{0, 2}, {45, 2}, {45, 5}, {32, 5}, {12, 15}, {0, 15}}};
  scene.output.energy = true;
  Simulation simulation(scene, {2, {}});
  while (!simulation.finished()) simulation.step();
  const EnergyBalance e = simulation.energy();
  EXPECT_LT(e.potential, 0.0);
  EXPECT_GT(e.kinetic_added, 0.0);
  EXPECT_LT(e.kinetic_added, e.kinetic);
  // As of a slide without it (EnergyTest): 2 % of the drop.
  EXPECT_NEAR(e.imbalance / e.potential, 0.0, 0.02);
}

TEST(MassScalingTest, ThreadsAndCheckpointsGiveTheSameBits) {
  Scene scene = small_slope("modern", 0.05, 10.0, 2.0);
  scene.materials.push_back(elastic(1e9));
  scene.materials[1].mass_scaling = 7.0;
  scene.bodies.push_back({.shape = Box{{0, 15, 0}, {12, 17, 0}}, .material = "elastic"});
  scene.bodies[0].material = "clay";
  for (const Integrator integrator : {Integrator::verlet, Integrator::kick_drift_kick}) {
    scene.numerics.integrator = integrator;
    if (integrator == Integrator::verlet) scene.numerics.cfl = 0.2;
    const Simulation whole = run_steps(scene, 120, {1, {}});
    RunOptions options{3, {}};
    options.oversubscribe = true;
    const Simulation first = run_steps(scene, 60, options);
    Simulation second(scene, first.snapshot(), {1, {}});
    for (int k = 0; k < 60; ++k) second.step();
    for (const char* field : {"position", "velocity", "stress", "density"})
      EXPECT_EQ(whole.field(field), second.field(field)) << field;
  }
}

}  // namespace
}  // namespace scarp::test
