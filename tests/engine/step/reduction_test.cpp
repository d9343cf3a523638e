// SPDX-License-Identifier: BSD-3-Clause
/// Everything that a step takes over the whole soil goes through the reduction.
#include <gtest/gtest.h>

#include <algorithm>
#include <condition_variable>
#include <functional>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "engine/errors.hpp"
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
    EXPECT_EQ(count("gather"), 0);
    EXPECT_EQ(count("min1"), 2);
    EXPECT_EQ(count("sum9"), 1);
    EXPECT_EQ(count("sum2"), 2);
    simulation.end_stage();
    listener->asked.clear();
    simulation.step();  // the next stage: its heights, its fastest, the start of its ledger
    EXPECT_EQ(count("gather"), 1);
    EXPECT_EQ(count("sum9"), 1);
    listener->asked.clear();
    static_cast<void>(simulation.energy());
    static_cast<void>(simulation.wall_reactions());
    static_cast<void>(simulation.face_hold_count());
    static_cast<void>(simulation.density_bound_count());
    EXPECT_EQ(listener->asked, Names({"sum9", "sum9", "sum1", "sum1"}));
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
      parts_.meet();
      const std::vector<double>& other = parts_.given_[1 - index_];
      values.insert(values.end(), other.begin(), other.end());
      parts_.meet();
    }
    void abort() noexcept override { parts_.abort(); }

   private:
    template <class Join>
    void join(std::span<double> values, const Join& two) {
      parts_.given_[index_].assign(values.begin(), values.end());
      parts_.meet();
      for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = two(parts_.given_[0].at(k), parts_.given_[1].at(k));
      parts_.meet();
    }
    Parts& parts_;
    std::size_t index_;
  };

 private:
  /// Waits for the other part. Errors: Error once one of both has stopped.
  void meet() {
    std::unique_lock lock(mutex_);
    const int meeting = meetings_;
    if (waits_ && !aborted_) {
      ++meetings_;
      waits_ = false;
      change_.notify_all();
      return;
    }
    waits_ = true;
    change_.wait(lock, [&] { return aborted_ || meetings_ != meeting; });
    if (meetings_ == meeting) throw Error("another part of the soil has stopped");
  }
  void abort() {
    const std::lock_guard lock(mutex_);
    aborted_ = true;
    change_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable change_;
  int meetings_ = 0;
  bool waits_ = false, aborted_ = false;
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

/// What a part of two ends with, where the second spoils something.
using Spoil = std::function<void(Simulation&)>;
std::string end_of_part(std::size_t index, Parts& parts, RunOptions options, const Spoil& spoil) {
  options.threads = 1;
  options.reduction = std::make_shared<Parts::Part>(parts, index);
  try {
    Simulation simulation(two_blocks("modern", index == 0, index == 1), options);
    if (spoil) spoil(simulation);
    for (int k = 0; k < 120; ++k) simulation.step();
    return "ran on";
  } catch (const SimulationInstability& error) {
    return "unstable";
  } catch (const Stopped&) {
    return "stopped";
  } catch (const std::exception& error) {
    return error.what();
  }
}

TEST(ReductionTest, APartThatThrowsDoesNotLeaveTheOtherWaiting) {
  const auto hook_into = [](const char* phase, PhaseHook hook) {
    return
        [phase, hook](Simulation& simulation) { simulation.on_phase(phase, When::before, hook); };
  };
  struct Case {
    Spoil spoil;
    std::function<bool()> stop;
    std::string end;
  };
  int looks = 0;
  for (const Case& one : {Case{hook_into("choose_time_step",
                                         [](PhaseView& view) {
                                           if (view.time() > 1e-3)
                                             throw std::runtime_error("enough");
                                         }),
                               {},
                               "enough"},
                          Case{hook_into("choose_time_step",
                                         [](PhaseView& view) {
                                           if (view.time() > 1e-3)
                                             view.write("velocity")[0] =
                                                 std::numeric_limits<double>::quiet_NaN();
                                         }),
                               {},
                               "unstable"},
                          // Only the look at every 50th step finds it.
                          Case{hook_into("watch",
                                         [](PhaseView& view) {
                                           if (view.time() > 1e-3) view.write("density")[0] = 1.0;
                                         }),
                               {},
                               "unstable"},
                          Case{{}, [] { return true; }, "stopped"},  // in the set-up
                          Case{{}, [&looks] { return ++looks == 200; }, "stopped"}}) {  // later
    Parts parts;
    std::string ends[2];
    const auto run = [&](std::size_t index) {
      RunOptions options;
      if (index == 1) options.stop = one.stop;
      ends[index] = end_of_part(index, parts, options, index == 1 ? one.spoil : Spoil());
    };
    std::thread other(run, 1);
    run(0);
    other.join();
    EXPECT_EQ(ends[1], one.end);
    EXPECT_EQ(ends[0], "another part of the soil has stopped");
  }
}

}  // namespace
}  // namespace scarp::test
