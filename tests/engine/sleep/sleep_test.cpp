// SPDX-License-Identifier: BSD-3-Clause
/// Soil that rests is left out, wakes when something happens near it, and changes no result by more
/// than what it was asked to.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <variant>

#include "engine/errors.hpp"
#include "engine/simulation.hpp"
#include "kernels/isa/kernel_table.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

bool same_states(const Simulation& a, const Simulation& b) {
  const Snapshot first = a.snapshot(), second = b.snapshot();
  if (first.items().size() != second.items().size()) return false;
  for (std::size_t k = 0; k < first.items().size(); ++k) {
    const auto &one = first.items()[k].values, &other = second.items()[k].values;
    const auto* numbers = std::get_if<std::vector<double>>(&one);
    if (numbers != nullptr ? !same_bits(*numbers, std::get<std::vector<double>>(other))
                           : one != other)
      return false;
  }
  return true;
}

double share_asleep(const Simulation& simulation) {
  return static_cast<double>(simulation.asleep_count()) /
         static_cast<double>(simulation.soil_count());
}

/// Steps until that share sleeps in the last stage; false: it never does.
bool run_until_asleep(Simulation& simulation, double share) {
  while (!simulation.finished()) {
    simulation.step();
    const bool last = simulation.stage_index() + 1 == simulation.scene().stages.size();
    if (last && share_asleep(simulation) >= share) return true;
  }
  return false;
}

/// A bed of sand 2 m wide and `height` deep in a smooth box, in balance but for what the lattice
/// adds at its surface; soft, so that few steps are a passage of sound.
Scene bed(double height, double spacing) {
  Scene scene;
  scene.spacing = spacing;
  scene.numerics = preset("modern");
  scene.numerics.sleep = 0.03;
  scene.materials = {
      {"sand", DruckerPrager{2e6, 0.3, 500.0, 0.576, 0.0, Cone::plane_strain}, 1600.0}};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {2, height, 0}}}};
  scene.walls = {
      wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 2, 0)}),
      wall_of("sides", WallKind::free_slip, {facet_2d(2, 0, 2, 3), facet_2d(0, 3, 0, 0)})};
  scene.initial_stress = InitialStress::geostatic;
  Stage settle = stage_for("settle", 2.0);
  settle.damping = 100.0;
  settle.reset_after = true;
  scene.stages = {settle, stage_for("rest", 4.0)};
  return scene;
}

/// The slope of the tests, with the numerics of each integrator, that fails while its ground rests.
Scene sliding(Integrator integrator, bool corrected, Precision precision = Precision::real64) {
  Scene scene = small_slope("modern", 1.0, 8.0, 1.4);
  scene.numerics.sleep = 0.06;
  scene.numerics.integrator = integrator;
  scene.numerics.cfl = integrator == Integrator::verlet ? 0.2 : 0.8;
  scene.numerics.force_correction = corrected;
  scene.numerics.precision = precision;
  return scene;
}

TEST(SleepTest, ABedAtRestSleepsAndThenNothingChangesAtAll) {
  Simulation simulation(bed(1.0, 0.1));
  ASSERT_TRUE(run_until_asleep(simulation, 1.0));
  const auto before = [&](const char* name) { return simulation.field(name); };
  const std::vector<double> position = before("position"), stress = before("stress"),
                            density = before("density");
  for (int step = 0; step < 200; ++step) simulation.step();
  EXPECT_EQ(simulation.asleep_count(), simulation.soil_count());
  EXPECT_TRUE(same_bits(position, simulation.field("position")));
  EXPECT_TRUE(same_bits(stress, simulation.field("stress")));
  EXPECT_TRUE(same_bits(density, simulation.field("density")));
  for (const double speed : simulation.field("velocity")) EXPECT_EQ(speed, 0.0);
  for (const double asleep : simulation.field("asleep")) EXPECT_EQ(asleep, 1.0);
}

TEST(SleepTest, AStageWakesEverything) {
  Simulation simulation(bed(1.0, 0.1));
  ASSERT_TRUE(run_until_asleep(simulation, 1.0));
  std::vector<Stage> next{simulation.scene().stages.back()};
  next[0].name = "next";
  simulation.set_following_stages(next);
  simulation.end_stage();
  simulation.step();
  EXPECT_EQ(simulation.asleep_count(), 0u);
}

TEST(SleepTest, ANumberOfThreadsChangesNothing) {
  for (const Integrator integrator : {Integrator::verlet, Integrator::kick_drift_kick}) {
    for (const bool corrected : {false, true}) {
      const Scene scene = sliding(integrator, corrected);
      RunOptions one, three;
      one.threads = 1;
      three.threads = 3;
      three.oversubscribe = true;
      Simulation a(scene, one), b(scene, three);
      ASSERT_TRUE(run_until_asleep(a, 0.2)) << static_cast<int>(integrator) << corrected;
      ASSERT_TRUE(run_until_asleep(b, 0.2));
      for (int step = 0; step < 300; ++step) {
        a.step();
        b.step();
      }
      EXPECT_TRUE(same_states(a, b)) << static_cast<int>(integrator) << corrected;
    }
  }
}

TEST(SleepTest, ARunGoesOnFromASnapshotBitForBit) {
  for (const Integrator integrator : {Integrator::verlet, Integrator::kick_drift_kick}) {
    for (const bool corrected : {false, true}) {
      for (const Precision precision : {Precision::real64, Precision::mixed}) {
        const Scene scene = sliding(integrator, corrected, precision);
        Simulation through(scene);
        ASSERT_TRUE(run_until_asleep(through, 0.2));
        Simulation resumed(scene, through.snapshot());
        EXPECT_EQ(resumed.asleep_count(), through.asleep_count());
        for (int step = 0; step < 300; ++step) {
          through.step();
          resumed.step();
        }
        EXPECT_TRUE(same_states(through, resumed))
            << static_cast<int>(integrator) << corrected << static_cast<int>(precision);
        const auto forces = through.wall_reactions(), again = resumed.wall_reactions();
        for (std::size_t w = 0; w < forces.size(); ++w) EXPECT_EQ(forces[w].force, again[w].force);
      }
    }
  }
}

TEST(SleepTest, ABlockThatFallsOnSleepingGroundWakesIt) {
  Scene scene = bed(0.8, 0.1);
  scene.stages = {stage_for("fall", 3.0)};
  Simulation simulation(scene);
  ASSERT_TRUE(run_until_asleep(simulation, 1.0));
  Scene with_block = scene;
  with_block.bodies.push_back({.shape = Box{{0.8, 2.0, 0}, {1.2, 2.4, 0}}});
  Simulation falls(with_block);
  // 0.4 m x 0.4 m of 2 m x 0.8 m fall: a tenth of the soil stays awake till it lands.
  ASSERT_TRUE(run_until_asleep(falls, 0.9));
  std::uint64_t least = falls.asleep_count();
  while (!falls.finished()) {
    falls.step();
    least = std::min(least, falls.asleep_count());
  }
  EXPECT_LT(static_cast<double>(least), 0.5 * static_cast<double>(falls.soil_count()));
}

TEST(SleepTest, EveryInstructionSetGoesOnFromASnapshotIn3D) {
  for (const kernels::Isa available : kernels::available_isas()) {
    const char* isa = kernels::isa_name(available);
    for (const Precision precision : {Precision::real64, Precision::mixed}) {
      Scene scene = small_collapse("modern", 0.04, 3.0);
      scene.numerics.sleep = 0.06;
      scene.numerics.precision = precision;
      RunOptions options;
      options.isa = isa;
      Simulation through(scene, options);
      ASSERT_TRUE(run_until_asleep(through, 0.3)) << isa;
      Simulation resumed(scene, through.snapshot());
      for (int step = 0; step < 100; ++step) {
        through.step();
        resumed.step();
      }
      EXPECT_TRUE(same_states(through, resumed)) << isa << static_cast<int>(precision);
    }
  }
}

double mean_of(const std::vector<double>& values, std::size_t component) {
  double sum = 0.0;
  for (std::size_t k = component; k < values.size(); k += 3) sum += values[k];
  return 3.0 * sum / static_cast<double>(values.size());
}

TEST(SleepTest, SoilBesideAWallThatGoesWakesAndRunsAsFar) {
  double moved[2];
  for (const bool sleeps : {false, true}) {
    Scene scene = small_collapse("modern", 0.04, 3.0);
    scene.stages[0].duration = 0.5;
    scene.numerics.sleep = sleeps ? 0.06 : 0.0;
    Simulation simulation(scene);
    while (simulation.stage_index() == 0 && !simulation.stage_ended()) simulation.step();
    if (sleeps) {
      ASSERT_EQ(share_asleep(simulation), 1.0);
    }
    simulation.step();  // the gate goes
    EXPECT_EQ(simulation.asleep_count(), 0u);
    while (!simulation.finished()) simulation.step();
    moved[sleeps] = mean_of(simulation.field("displacement"), 0);
    if (sleeps) {
      EXPECT_GT(share_asleep(simulation), 0.5);
    }
  }
  EXPECT_NEAR(moved[1], moved[0], 0.005 * moved[0]);
}

/// A lid is pressed into sand slower than what counts as calm: no rate would ever wake the soil.
TEST(SleepTest, SlowLoadIsNotLocked) {
  double base[2];
  std::uint64_t most_asleep = 0;
  const double s = 0.06, speed = 2e-3, weight = 1600.0 * 9.81 * 2.0;
  for (const bool sleeps : {false, true}) {
    Scene scene = bed(1.0, 0.1);
    scene.numerics.sleep = sleeps ? s : 0.0;
    Wall lid = wall_of("lid", WallKind::no_slip, {facet_2d(2, 1, 0, 1)});
    lid.velocity = {0, -speed, 0};
    lid.moves_from = "rest";
    scene.walls.push_back(lid);
    scene.stages[1].duration = 1.0;
    Simulation simulation(scene);
    while (!simulation.finished()) {
      simulation.step();
      if (simulation.stage_index() == 1)
        most_asleep = std::max(most_asleep, simulation.asleep_count());
    }
    base[sleeps] = -simulation.wall_reactions()[0].force[1];
  }
  EXPECT_GT(most_asleep, 0u);
  // The lid adds more than a tenth of the weight. All layers are out of balance in the same
  // direction here, which is the worst case.
  EXPECT_GT(base[0], 1.1 * weight);
  EXPECT_NEAR(base[1], base[0], s * weight);
}

TEST(SleepTest, MomentumThatSleepKeepsBackIsASmallShareOfTheWeight) {
  Simulation simulation(sliding(Integrator::kick_drift_kick, false));
  std::array<double, 2> force{};
  double asleep = 0.0;
  simulation.on_phase("sweep_force", When::after, [&](PhaseView& view) {
    force = {};
    asleep = 0.0;
    const auto ids = view.ids();
    const auto sleeps = view.read("asleep");
    for (std::size_t k = 0; k < ids.size(); ++k) {
      if (ids[k] < 0 || sleeps[k] == 0.0) continue;
      asleep += 1.0;
      force[0] += view.read("acceleration", 0)[k];
      force[1] += view.read("acceleration", 1)[k] - 9.81;
    }
  });
  ASSERT_TRUE(run_until_asleep(simulation, 0.3));
  while (!simulation.finished()) simulation.step();
  ASSERT_GT(asleep, 0.0);
  EXPECT_LT(std::hypot(force[0], force[1]), 0.06 * 9.81 * asleep);
}

TEST(SleepTest, AForceOfAHookWakes) {
  Simulation simulation(bed(1.0, 0.1));
  bool pushes = false;
  simulation.on_phase("sweep_force", When::after, [&pushes](PhaseView& view) {
    if (pushes) view.write("acceleration", 0)[0] += 1e-6;
  });
  ASSERT_TRUE(run_until_asleep(simulation, 1.0));
  pushes = true;
  simulation.step();
  simulation.step();
  EXPECT_EQ(simulation.asleep_count(), 0u);
}

TEST(SleepTest, WithoutTheKeyNothingIsKept) {
  Scene scene = bed(0.5, 0.1);
  scene.numerics.sleep = 0.0;
  const Simulation simulation = run_steps(scene, 5);
  EXPECT_THROW((void)simulation.field("asleep"), Error);
  scene.numerics.sleep = 0.03;
  scene.gravity = {0, 0, 0};
  EXPECT_THROW((void)run_steps(scene, 5).field("asleep"), Error);
}

TEST(SleepTest, EnergyClosesWithTheLineOfSleep) {
  Scene scene = sliding(Integrator::kick_drift_kick, false);
  scene.output.energy = true;
  Simulation simulation(scene);
  while (!simulation.finished()) simulation.step();
  ASSERT_GT(simulation.asleep_count(), 0u);
  const EnergyBalance energy = simulation.energy();
  EXPECT_GT(energy.sleep, 0.0);
  // As slope_2d asks without sleep: powers are sampled every 10 steps.
  EXPECT_LT(std::abs(energy.imbalance), 0.02 * std::abs(energy.potential));
}

}  // namespace
}  // namespace scarp::test
