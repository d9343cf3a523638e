// SPDX-License-Identifier: BSD-3-Clause
/// Everything that a step takes over the whole soil goes through the reduction.
#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "engine/simulation.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// Writes down what is asked: "max4" for the maxima of four values; and multiplies sums.
class Listener : public Reduction {
 public:
  void maximum(std::span<double> values) override { note("max", values); }
  void minimum(std::span<double> values) override { note("min", values); }
  void sum(std::span<double> values) override {
    note("sum", values);
    for (double& value : values) value *= factor;
  }
  void gather(std::vector<double>& values) override { note("gather", values); }

  std::vector<std::string> asked;
  double factor = 1.0;

 private:
  void note(const char* kind, std::span<const double> values) {
    asked.push_back(kind + (std::string(kind) == "gather" ? "" : std::to_string(values.size())));
  }
};

RunOptions with(std::shared_ptr<Reduction> reduction) {
  RunOptions options;
  options.threads = 1;
  options.reduction = std::move(reduction);
  return options;
}

TEST(ReductionTest, SeesWhatAStepTakesOverAllSoil) {
  using Names = std::vector<std::string>;
  for (const char* name : {"paper", "modern"}) {
    const auto listener = std::make_shared<Listener>();
    Scene scene = small_slope(name, 10.0, 1.0, 1.0);
    scene.output.energy = true;
    Simulation simulation(scene, with(listener));
    listener->asked.clear();
    simulation.step();
    listener->asked.clear();
    simulation.step();
    // Whether lists are outdated; the extremes of the time step and the material of the fastest.
    const bool verlet = std::string(name) == "paper";
    EXPECT_EQ(listener->asked,
              verlet ? Names({"max1", "max4", "min1"}) : Names({"max4", "min1", "max1", "max1"}));
    const auto count = [&](const std::string& what) {
      return std::count(listener->asked.begin(), listener->asked.end(), what);
    };
    while (simulation.last_step().step < 49) simulation.step();
    EXPECT_EQ(count("sum4"), 4);  // powers of the forces at every tenth step
    EXPECT_EQ(count("gather"), 0);
    listener->asked.clear();
    simulation.step();  // the watch looks: height of the soil, stored energies, mass; lost soil
    EXPECT_EQ(count("gather"), 1);
    EXPECT_EQ(count("sum6"), 1);
    EXPECT_EQ(count("sum2"), 1);
    simulation.end_stage();
    listener->asked.clear();
    simulation.step();  // the next stage: its heights, its fastest, the start of its ledger
    EXPECT_EQ(count("gather"), 1);
    EXPECT_EQ(count("sum6"), 1);
    listener->asked.clear();
    static_cast<void>(simulation.energy());
    static_cast<void>(simulation.wall_reactions());
    static_cast<void>(simulation.face_hold_count());
    static_cast<void>(simulation.density_bound_count());
    EXPECT_EQ(listener->asked, Names({"sum6", "sum9", "sum1", "sum1"}));
  }
}

TEST(ReductionTest, SumsAreWhatItSays) {
  const auto twice = std::make_shared<Listener>();
  twice->factor = 2.0;
  const Scene scene = small_slope("modern", 10.0, 1.0, 1.0);
  Simulation one(scene, {1, {}}), two(scene, with(twice));
  for (int k = 0; k < 20; ++k) {
    one.step();
    two.step();
  }
  EXPECT_GT(one.energy().kinetic, 0.0);
  EXPECT_EQ(two.energy().kinetic, 2.0 * one.energy().kinetic);
  EXPECT_EQ(two.wall_reactions()[0].force[1], 2.0 * one.wall_reactions()[0].force[1]);
  EXPECT_EQ(two.field("position"), one.field("position"));
}

/// Two parts in two threads; each value waits for its like.
class Parts {
 public:
  class Part : public Reduction {
   public:
    Part(Parts& parts, std::size_t index) : parts_(parts), index_(index) {}
    void maximum(std::span<double> values) override {
      join(values, [](double a, double b) { return std::max(a, b); });
    }
    void minimum(std::span<double> values) override {
      join(values, [](double a, double b) { return std::min(a, b); });
    }
    void sum(std::span<double> values) override {
      join(values, [](double a, double b) { return a + b; });
    }
    void gather(std::vector<double>& values) override {
      parts_.given_[index_] = values;
      parts_.meet_.arrive_and_wait();
      const std::vector<double>& other = parts_.given_[1 - index_];
      values.insert(values.end(), other.begin(), other.end());
      parts_.meet_.arrive_and_wait();
    }

   private:
    template <class Join>
    void join(std::span<double> values, const Join& two) {
      parts_.given_[index_].assign(values.begin(), values.end());
      parts_.meet_.arrive_and_wait();
      for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = two(parts_.given_[0].at(k), parts_.given_[1].at(k));
      parts_.meet_.arrive_and_wait();
    }
    Parts& parts_;
    std::size_t index_;
  };

 private:
  std::barrier<> meet_{2};
  std::vector<double> given_[2];
};

/// Two blocks out of each other's reach, one of them stiffer, on a base that only one meets.
Scene two_blocks(const char* preset_name, bool left, bool right) {
  Scene scene = elastic_column(preset_name, 1.0, 0.1);
  scene.materials = {elastic(), elastic(40e6)};
  scene.materials[1].name = "stiff";
  scene.bodies.clear();
  if (left) scene.bodies.push_back({.shape = Box{{0, 0, 0}, {1, 1, 0}}, .material = "elastic"});
  if (right) {
    scene.bodies.push_back({.shape = Box{{3, 0.5, 0}, {4, 2, 0}}, .material = "stiff"});
    scene.bodies.back().velocity = {0.1, 0.0, 0.0};
  }
  scene.walls = {wall_of("base", WallKind::no_slip, {facet_2d(-1, 0, 6, 0)})};
  scene.output.energy = true;
  Stage settle = stage_for("settle", 10.0);
  settle.until = StageEnd::rest;
  settle.reset_after = true;  // damped by the height of all soil
  scene.stages = {settle};
  return scene;
}

struct Outcome {
  StepReport report;
  EnergyBalance energy;
  std::vector<double> position;
  double reaction = 0.0;
};

Outcome outcome_of(const Scene& scene, std::shared_ptr<Reduction> reduction) {
  Simulation simulation(scene, with(std::move(reduction)));
  for (int k = 0; k < 120; ++k) simulation.step();
  return {simulation.last_step(), simulation.energy(), simulation.field("position"),
          simulation.wall_reactions()[0].force[1]};
}

TEST(ReductionTest, TwoPartsStepAsOne) {
  for (const char* name : {"paper", "modern"}) {
    const Outcome whole = outcome_of(two_blocks(name, true, true), nullptr);
    Parts parts;
    Outcome part[2];
    const auto run = [&](std::size_t index) {
      part[index] = outcome_of(two_blocks(name, index == 0, index == 1),
                               std::make_shared<Parts::Part>(parts, index));
    };
    std::thread other(run, 1);
    run(0);
    other.join();
    // Sums over neighbours run in another order: 120 steps of round-off, 1e-16 of places of 1 m,
    // of energies of 1e4 J and forces of 1e4 N, which stiffness and damping keep from growing.
    for (const Outcome& one : part) {
      EXPECT_NEAR(one.report.time, whole.report.time, 1e-13);
      EXPECT_NEAR(one.report.time_step, whole.report.time_step, 1e-15);
      EXPECT_EQ(one.report.limit, whole.report.limit);
      EXPECT_EQ(one.report.signal_material, whole.report.signal_material);
      EXPECT_NEAR(one.report.max_velocity, whole.report.max_velocity, 1e-11);
      EXPECT_NEAR(one.energy.kinetic, whole.energy.kinetic, 1e-8);
      EXPECT_NEAR(one.energy.potential, whole.energy.potential, 1e-8);
      EXPECT_NEAR(one.energy.damping, whole.energy.damping, 1e-8);
      EXPECT_NEAR(one.reaction, whole.reaction, 1e-6);
    }
    std::vector<double> both = part[0].position;
    both.insert(both.end(), part[1].position.begin(), part[1].position.end());
    ASSERT_EQ(both.size(), whole.position.size());
    for (std::size_t k = 0; k < both.size(); ++k) EXPECT_NEAR(both[k], whole.position[k], 1e-12);
  }
}

}  // namespace
}  // namespace scarp::test
