// SPDX-License-Identifier: BSD-3-Clause
/// Hooks before and after the phases of a step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/errors.hpp"
#include "engine/simulation.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// A free elastic block under uniform stress, which lets go as it falls.
Scene free_block(Integrator integrator, const Vec3& gravity) {
  Scene scene = elastic_column("modern", 1.0, 0.1);
  scene.numerics.integrator = integrator;
  // Verlet's one sweep; with corrections it has two, as kick-drift-kick.
  if (integrator == Integrator::verlet) scene.numerics.gradient_correction = false;
  scene.numerics.cfl = 0.2;
  scene.walls.clear();
  scene.gravity = gravity;
  scene.initial_stress = InitialStress::uniform;
  scene.uniform_stress = {-1e4, -1e4, -1e4, 0.0, 0.0, 0.0};
  scene.bodies[0].velocity_field = {"0.01 * y", "0.02 * x"};
  scene.stages = {stage_for("fall", 10.0), stage_for("fall on", 10.0)};
  return scene;
}

const char* force_sweep(Integrator integrator) {
  return integrator == Integrator::verlet ? "sweep_all" : "sweep_force";
}

void add_force(Simulation& simulation, Integrator integrator, const Vec3& more) {
  simulation.on_phase(force_sweep(integrator), When::after, [more](PhaseView& view) {
    for (int a = 0; a < 2; ++a) {
      const std::span<double> acceleration = view.write("acceleration", a);
      for (double& value : acceleration) value += more[static_cast<std::size_t>(a)];
    }
  });
}

constexpr Integrator integrators[]{Integrator::verlet, Integrator::kick_drift_kick};

TEST(HookTest, AUniformForceIsGravity) {
  const Vec3 gravity{0.0, -9.81, 0.0}, more{2.0, 4.0, 0.0};
  for (const Integrator integrator : integrators) {
    Simulation whole(free_block(integrator, {2.0, -5.81, 0.0}), {1, {}});
    Simulation hooked(free_block(integrator, gravity), {1, {}});
    add_force(hooked, integrator, more);
    for (int k = 0; k < 100; ++k) {
      if (k == 60) {
        whole.end_stage();
        hooked.end_stage();
      }
      whole.step();
      hooked.step();
    }
    // The sums of the three accelerations round differently, by 1e-15 of 100 m/s2 at first. Sound
    // carries that on, it does not grow: 100 steps of 3e-4 s make 3e-15 m/s, and positions of 1 m
    // round by 1e-16 each step, which the stiffness answers with c/dx = 800/s times that.
    EXPECT_NEAR(hooked.last_step().time, whole.last_step().time, 1e-14);
    const auto x = whole.field("position"), y = hooked.field("position");
    const auto v = whole.field("velocity"), w = hooked.field("velocity");
    for (std::size_t k = 0; k < x.size(); ++k) {
      EXPECT_NEAR(x[k], y[k], 1e-13);
      EXPECT_NEAR(v[k], w[k], 1e-11);
    }
    EXPECT_GT(std::abs(whole.field("velocity")[1]), 0.05);
  }
}

TEST(HookTest, AForceBoundsTheTimeStep) {
  constexpr double force = 1e6;  // [m/s2]: sqrt(h/a) is a quarter of h/c
  for (const Integrator integrator : integrators) {
    Scene scene = free_block(integrator, {});
    scene.initial_stress = InitialStress::zero;
    scene.bodies[0].velocity_field.clear();
    Simulation simulation(scene, {1, {}});
    add_force(simulation, integrator, {0.0, force, 0.0});
    const StepReport& report = simulation.step();
    EXPECT_EQ(report.limit, StepLimit::force);
    EXPECT_NEAR(report.time_step, 0.2 * std::sqrt(0.12 / force), 1e-15);
  }
}

TEST(HookTest, IsCalledAtItsPlaceAndInTheOrderGiven) {
  Simulation simulation(free_block(Integrator::kick_drift_kick, {}), {1, {}});
  std::string calls;
  simulation.on_phase("drift_half", When::after, [&](PhaseView&) { calls += "c"; });
  simulation.on_phase("drift_half", When::before, [&](PhaseView& view) {
    EXPECT_EQ(view.phase(), "drift_half");
    EXPECT_EQ(view.time(), simulation.last_step().time);
    EXPECT_GT(view.time_step(), 0.0);
    calls += "a";
  });
  simulation.on_phase("drift_half", When::before, [&](PhaseView&) { calls += "b"; });
  simulation.on_phase("enter_stage", When::before, [&](PhaseView&) { calls += "s"; });
  simulation.step();
  simulation.step();
  EXPECT_EQ(calls, "sabcabcabcabc");
  calls.clear();
  Simulation copy = simulation.clone();
  copy.step();
  EXPECT_EQ(calls, "abcabc");
}

TEST(HookTest, SeesTheParticlesWithoutCopies) {
  Simulation simulation(free_block(Integrator::verlet, {}), {1, {}});
  const std::vector<double> velocity = simulation.field("velocity");
  std::size_t seen = 0;
  simulation.on_phase("advance_verlet", When::before, [&](PhaseView& view) {
    const auto ids = view.ids();
    const auto x = view.read("velocity", 1);
    ASSERT_EQ(x.size(), ids.size());
    for (std::size_t k = 0; k < ids.size(); ++k) {
      if (ids[k] < 0) continue;
      EXPECT_EQ(x[k], velocity[3 * static_cast<std::size_t>(ids[k]) + 1]);
      ++seen;
    }
    EXPECT_EQ(x.data(), view.write("velocity", 1).data());
  });
  simulation.step();
  EXPECT_EQ(seen, simulation.soil_count());
}

template <class Call>
void expect_error(const Call& call, const std::string& part) {
  try {
    call();
    ADD_FAILURE() << "no error that says " << part;
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(HookTest, MisuseIsNamed) {
  Simulation simulation(free_block(Integrator::verlet, {}), {1, {}});
  const auto nothing = [](PhaseView&) {};
  expect_error([&] { simulation.on_phase("kick_half", When::before, nothing); },
               "no such phase; there are pack_soil, decide_rebuild");
  expect_error([&] { simulation.on_phase("watch", When::before, {}); }, "empty");
  const auto in_hook = [](const char* phase, When when, PhaseHook hook, const char* part) {
    Simulation run(free_block(Integrator::kick_drift_kick, {}), {1, {}});
    run.on_phase(phase, when, std::move(hook));
    expect_error([&] { run.step(); }, part);
  };
  in_hook(
      "watch", When::before, [](PhaseView& v) { v.read("spin"); }, "no field 'spin' is stored");
  in_hook(
      "watch", When::before, [](PhaseView& v) { v.read("velocity", 2); }, "no component 2 in 2D");
  in_hook(
      "watch", When::before, [](PhaseView& v) { v.read("velocity", -1); }, "no component -1");
  in_hook(
      "watch", When::before, [](PhaseView& v) { v.read("moment"); }, "neither reads nor writes");
  in_hook(
      "watch", When::after, [](PhaseView& v) { v.write("velocity"); }, "does not write it");
  in_hook(
      "pack_soil", When::before, [](PhaseView& v) { v.write("acceleration"); },
      "may not be changed before phase 'pack_soil', which does not read it. Try "
      "position, velocity");
}

TEST(HookTest, PhasesTellWhatTheyTouch) {
  const Simulation simulation(free_block(Integrator::kick_drift_kick, {}), {1, {}});
  const std::vector<PhaseInfo> phases = simulation.phases();
  ASSERT_FALSE(phases.empty());
  EXPECT_EQ(phases.front().name, "enter_stage");
  EXPECT_EQ(phases.back().name, "end_step");
  for (const PhaseInfo& phase : phases) {
    if (phase.name != "kick_half") continue;
    EXPECT_EQ(phase.reads, (std::vector<std::string>{"velocity", "acceleration"}));
    EXPECT_EQ(phase.writes, std::vector<std::string>{"velocity"});
  }
}

/// A block at rest without weight that only a hook drives.
Scene resting_block(Integrator integrator) {
  Scene scene = free_block(integrator, {});
  scene.initial_stress = InitialStress::zero;
  scene.bodies[0].velocity_field.clear();
  scene.output.energy = true;
  return scene;
}

TEST(HookTest, WhatAForceAddsIsNoEnergyFromNothing) {
  const double mass = 2000.0;  // of 1 m2
  for (const Integrator integrator : integrators) {
    Simulation simulation(resting_block(integrator), {1, {}});
    add_force(simulation, integrator, {3.0, 4.0, 0.0});
    for (int k = 0; k < 400; ++k) simulation.step();
    const double speed = 5.0 * simulation.last_step().time;
    const EnergyBalance e = simulation.energy();
    EXPECT_NEAR(e.kinetic, 0.5 * mass * speed * speed, 1e-9 * mass * speed * speed);
    // Power times step lags by half a step: 400 steps are off by an 800th of their half.
    EXPECT_NEAR(e.hooks / e.kinetic, 1.0, 1.0 / 300) << static_cast<int>(integrator);
    EXPECT_NEAR(e.imbalance / e.kinetic, 0.0, 1.0 / 300) << static_cast<int>(integrator);
  }
}

/// Of a block that lets go of its stress meanwhile: force times way of its centre.
TEST(HookTest, OnlyTheForceOfTheHookIsItsWork) {
  const Vec3 more{3.0, 4.0, 0.0};
  for (const Integrator integrator : integrators) {
    Simulation simulation(free_block(integrator, {}), {1, {}});
    add_force(simulation, integrator, more);
    for (int k = 0; k < 400; ++k) simulation.step();
    const std::vector<double> moved = simulation.field("displacement");
    double work = 0.0;
    for (std::size_t k = 0; k < moved.size(); ++k) work += 2000.0 * 0.01 * more[k % 3] * moved[k];
    // As above.
    EXPECT_NEAR(simulation.energy().hooks / work, 1.0, 1.0 / 300) << static_cast<int>(integrator);
  }
}

TEST(HookTest, AForceMayMakeSoilFasterThanSound) {
  for (const Integrator integrator : integrators) {
    Scene scene = resting_block(integrator);
    scene.materials[0].model.set("youngs_modulus", 1e4);  // c_p = 2.6 m/s
    Simulation simulation(scene, {1, {}});
    add_force(simulation, integrator, {0.0, 10.0, 0.0});
    while (simulation.last_step().time < 2.0) simulation.step();
    EXPECT_GT(simulation.last_step().max_velocity, 15.0);
  }
}

/// A hook may also set the fields themselves: here it throws the block to and fro.
TEST(HookTest, SpeedsThatAHookSetsAreItsWork) {
  Simulation simulation(resting_block(Integrator::kick_drift_kick), {1, {}});
  double kinetic = 0.0, before = 0.0;
  simulation.on_phase("hold_off_faces", When::after, [&](PhaseView& view) {
    const double speed = 0.5 * std::sin(200.0 * view.time());
    for (double& v : view.write("velocity", 0)) v += speed - before;
    before = speed;
  });
  for (int k = 0; k < 400; ++k) {
    simulation.step();
    const EnergyBalance e = simulation.energy();
    kinetic = std::max(kinetic, e.kinetic);
  }
  const EnergyBalance e = simulation.energy();
  EXPECT_GT(kinetic, 0.5 * 2000.0 * 0.2);
  EXPECT_NEAR(e.hooks, e.kinetic, 1e-9 * kinetic);
}

TEST(HookTest, ABlowUpIsFoundBesideAHook) {
  Scene scene = free_block(Integrator::verlet, {});
  scene.numerics.cfl = 2.0;
  Simulation simulation(scene, {1, {}});
  add_force(simulation, Integrator::verlet, {0.0, 1.0, 0.0});
  EXPECT_THROW(for (int k = 0; k < 2000; ++k) simulation.step(), SimulationInstability);
}

}  // namespace
}  // namespace scarp::test
