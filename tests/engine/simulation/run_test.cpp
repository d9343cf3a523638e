// SPDX-License-Identifier: BSD-3-Clause
/// Properties every run must have: thread identity, copies, stages, what is left out, clear
/// failure.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <string>

#include "engine/errors.hpp"
#include "kernels/isa/kernel_table.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

std::vector<double> everything(const Simulation& simulation) {
  std::vector<double> all = simulation.field("position");
  for (const FieldInfo& info : simulation.fields()) {
    const auto values = simulation.field(info.name);
    all.insert(all.end(), values.begin(), values.end());
  }
  return all;
}

struct Setting {
  std::string name;
  Scene scene;
  int steps;
};

std::vector<Setting> settings() {
  std::vector<Setting> all;
  for (const std::string preset_name : {"paper", "modern"}) {
    for (const Integrator integrator : {Integrator::verlet, Integrator::kick_drift_kick}) {
      const std::string label =
          preset_name + (integrator == Integrator::verlet ? "/verlet" : "/kick_drift_kick");
      Scene slope = small_slope(preset_name, 0.05, 10.0, 1.8);
      slope.numerics.integrator = integrator;
      if (integrator == Integrator::verlet) slope.numerics.cfl = 0.2;  // at 1 it blows up
      all.push_back({"slope/" + label, slope, 250});
      Scene collapse = small_collapse(preset_name, 0.02, 10.0);
      collapse.numerics.integrator = integrator;
      if (integrator == Integrator::verlet) collapse.numerics.cfl = 0.2;
      all.push_back({"collapse/" + label, collapse, 120});
    }
  }
  return all;
}

TEST(ThreadsTest, TwoThreadsGiveTheSameBitsAsOne) {
  for (const Setting& setting : settings()) {
    const Simulation one = run_steps(setting.scene, setting.steps, {1, {}});
    const Simulation two = run_steps(setting.scene, setting.steps, {2, {}});
    EXPECT_EQ(everything(one), everything(two)) << setting.name;
  }
}

TEST(IsaTest, EveryInstructionSetGivesTheSameRunToRoundOff) {
  Scene scene = small_slope("modern", 0.02, 10.0, 1.8);
  const Simulation best = run_steps(scene, 40, {1, {}});
  for (const kernels::Isa isa : kernels::available_isas()) {
    const Simulation other = run_steps(scene, 40, {1, kernels::isa_name(isa)});
    EXPECT_EQ(other.isa(), kernels::isa_name(isa));
    const auto a = best.field("position"), b = other.field("position");
    // eps times coordinates of 45 m times 40 steps: 4e-13; ten times that for sums over 28
    // neighbours.
    for (std::size_t k = 0; k < a.size(); ++k) ASSERT_NEAR(a[k], b[k], 4e-12);
  }
}

TEST(CloneTest, GoesOnBitForBit) {
  Simulation original = run_steps(small_slope("modern", 0.05, 10.0, 1.8), 60);
  Simulation copy = original.clone();
  for (int k = 0; k < 60; ++k) {
    original.step();
    copy.step();
  }
  EXPECT_EQ(everything(original), everything(copy));
}

TEST(StagesTest, ReducedStrengthFailsAndFullStrengthHolds) {
  Simulation settled(small_slope("modern", 0.5, 2.0, 1.0), {1, {}});
  while (!settled.stage_ended()) settled.step();
  Simulation failing = settled.clone();
  Stage cut = stage_for("fail", 2.0);
  cut.strength_reduction = 2.0;
  failing.set_following_stages({cut});
  while (!settled.finished()) settled.step();
  while (!failing.finished()) failing.step();
  // The failure criterion: 1 % of the slope's 10 m.
  EXPECT_LT(std::abs(settled.probe(0).displacement[1]), 0.02);
  EXPECT_GT(-failing.probe(0).displacement[1], 0.1);
  EXPECT_EQ(settled.last_step().stage_time, 2.0);
}

TEST(StagesTest, RemovedGateLetsTheSandOut) {
  Simulation simulation(small_collapse("modern", 0.02, 0.25), {2, {}});
  const std::size_t count = simulation.soil_count();
  while (!simulation.finished()) simulation.step();
  const auto position = simulation.field("position");
  double front = 0.0, lowest = 1.0;
  for (std::size_t k = 0; k < position.size(); k += 3) {
    ASSERT_TRUE(std::isfinite(position[k]));
    front = std::max(front, position[k]);
    lowest = std::min(lowest, position[k + 2]);
    EXPECT_GT(position[k + 1], -0.001);  // nothing through the symmetry planes
    EXPECT_LT(position[k + 1], 0.161);
  }
  EXPECT_EQ(position.size(), 3 * count);
  EXPECT_GT(front, 0.27);  // has begun to run out
  EXPECT_LT(front,
            0.24 + 0.25 * std::sqrt(2 * 9.81 * 0.16));  // but no faster than free fall's speed
  EXPECT_GT(lowest, 0.0);                               // nothing through the base
}

TEST(UnusedTest, WhatASceneDoesNotUseIsNotStored) {
  Simulation elastic_only(elastic_column("modern", 1.0, 0.1));
  EXPECT_THROW(static_cast<void>(elastic_only.field("accumulated_plastic_strain")), Error);
  Scene plain = small_slope("modern", 0.1, 0.1, 1.0), rich = plain;
  plain.numerics.gradient_correction = false;
  plain.numerics.stress_diffusion = 0.0;
  rich.numerics.artificial_stress = 0.3;
  rich.output.energy = true;
  Simulation lean(plain, {1, {}}), full(rich, {1, {}});
  const auto more = [&](const Simulation& with, const Simulation& without) {
    return (static_cast<double>(with.memory_bytes()) -
            static_cast<double>(without.memory_bytes())) /
           static_cast<double>(lean.soil_count());
  };
  EXPECT_GE(more(full, lean), 8.0 * (3 + 6 + 3));  // moment 3, diffusion 1 + 4 + 1, work 3 doubles
  // Records of artificial stress are stored once some soil is in tension: 8 doubles and a byte.
  rich.initial_stress = InitialStress::uniform;
  rich.uniform_stress = {1.0, 1.0, 1.0, 0.0, 0.0, 0.0};
  Simulation tensile(rich, {1, {}});
  EXPECT_EQ(more(tensile, full), 0.0);
  full.step();
  tensile.step();
  EXPECT_GE(more(tensile, full), 65.0);
  const auto used = [](const Simulation& simulation, const std::string& name) {
    for (const UsedFeature& feature : simulation.features()) {
      if (feature.name == name) return feature.used;
    }
    ADD_FAILURE() << "no feature " << name;
    return false;
  };
  EXPECT_FALSE(used(lean, "stress diffusion"));
  EXPECT_TRUE(used(full, "stress diffusion"));
  EXPECT_FALSE(used(lean, "artificial stress"));
  EXPECT_TRUE(used(full, "artificial stress"));
}

TEST(ExtremeTest, ThePapersLiteralStiffnessSinksTheSlope) {
  Scene scene = small_slope("modern", 30.0, 0.1, 1.0);
  scene.materials[0].model.set("youngs_modulus", 100e3);  // Table 1 prints kPa
  scene.stages[0].damping = 1.0;
  scene.initial_stress = InitialStress::zero;  // else the weight would be carried from the start
  Simulation simulation(scene, {2, {}});
  bool stopped = false;
  try {
    while (!simulation.stage_ended()) simulation.step();
  } catch (const SimulationInstability&) {
    stopped = true;  // a verdict too
  }
  if (!stopped) {
    const ProbeSample crest = simulation.probe(0);
    EXPECT_TRUE(std::isfinite(crest.displacement[1]));
    EXPECT_LT(crest.displacement[1], -5.0);  // 9 to 13 of 15 m at rest
  }
}

TEST(ProfileTest, TimesEveryPhaseOnceAndNoMoreThanPassed) {
  for (const char* name : {"paper", "modern"}) {
    Simulation simulation(small_slope(name, 0.05, 0.05, 1.5));
    const auto start = std::chrono::steady_clock::now();
    for (int k = 0; k < 20; ++k) simulation.step();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    double sum = 0.0;
    std::set<std::string> names;
    for (const PhaseTime& time : simulation.profile()) {
      EXPECT_GE(time.seconds, 0.0);
      sum += time.seconds;
      EXPECT_TRUE(names.insert(time.phase).second) << time.phase;
    }
    EXPECT_TRUE(names.contains("pack_soil"));
    EXPECT_EQ(names.contains("sweep_all"), std::string(name) == "paper");
    EXPECT_GT(sum, 0.0);
    EXPECT_LE(sum, passed.count());
  }
}

}  // namespace
}  // namespace scarp::test
