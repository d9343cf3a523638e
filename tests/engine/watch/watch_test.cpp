// SPDX-License-Identifier: BSD-3-Clause
/// States that soil cannot have are found soon and named in full; states of soil are not.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <random>

#include "engine/check/warnings.hpp"
#include "engine/setup.hpp"
#include "engine/step/step_phases.hpp"
#include "engine/watch/watch.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr std::size_t changed = 17;  ///< slot that the tests spoil

State resting_slope() { return make_state(small_slope("modern", 1.0, 1.0, 1.0), {1, {}}); }

void expect_found(const State& state, const std::string& field, double value) {
  const auto found = inspect(state);
  ASSERT_TRUE(found) << field;
  EXPECT_EQ(found->field, field);
  EXPECT_EQ(found->particle, state.particles.ids()[changed]);
  EXPECT_EQ(found->position[1], state.particles.component(Field::position, 1)[changed]);
  if (std::isfinite(value)) {
    EXPECT_EQ(found->value, value);
  }
  const std::string message = found->message();
  for (const std::string& part :
       {field, fmt::format("particle {}", found->particle), std::string("step 1 "),
        std::string("'settle'"), std::string("Possible causes"), std::string("Try")}) {
    EXPECT_NE(message.find(part), std::string::npos) << part << " in " << message;
  }
}

TEST(WatchTest, SoundStateIsLetPass) { EXPECT_FALSE(inspect(resting_slope())); }

TEST(WatchTest, DensityOutOfBoundsIsNamed) {
  for (const double density : {-1.0, 0.0, 19.0, 21000.0, std::nan("")}) {
    State state = resting_slope();
    state.particles.component(Field::density)[changed] = density;
    expect_found(state, "density", density);
  }
}

TEST(WatchTest, StressThatIsNotFiniteIsNamed) {
  for (const double stress : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    State state = resting_slope();
    state.particles.component(Field::stress, 3)[changed] = stress;
    expect_found(state, "stress", stress);
  }
}

TEST(WatchTest, GrainsFasterThanSoundAreNamed) {
  State state = resting_slope();
  // c_p = 259 m/s; the bound is twice that from rest.
  state.particles.component(Field::velocity, 0)[changed] = 600.0;
  expect_found(state, "speed", 600.0);
  state.particles.component(Field::velocity, 0)[changed] = 450.0;
  const auto slower = inspect(state);
  EXPECT_TRUE(!slower || slower->field != "speed");
}

TEST(WatchTest, EnergyFromNothingIsFound) {
  State state = resting_slope();
  std::mt19937 random(1);
  std::uniform_real_distribution<double> speed(-40.0, 40.0);  // far below that of sound
  for (std::int64_t k = 0; k < state.particles.count(); ++k)
    state.particles.component(Field::velocity, 0)[k] = speed(random);
  const auto found = inspect(state);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->unit, "J/m");
  EXPECT_GT(found->value, found->limit);
  // The mean square of the speeds is 40^2/3; nothing has fallen, stress is as it was.
  const double mass = 2000.0 * static_cast<double>(state.particles.count());
  EXPECT_NEAR(found->value, 0.5 * mass * 1600.0 / 3.0, 0.1 * found->value);
}

/// All soil 50 m lower and with so many times the energy of that fall, which its stress, 150 J/m3
/// of 1 MJ/m3, adds nothing to: twice that is allowed.
TEST(WatchTest, WhatHasFallenMayBeSpentOnce) {
  for (const double times : {1.0, 1.9, 2.1}) {
    State state = resting_slope();
    constexpr double fallen = 50.0;
    for (std::int64_t k = 0; k < state.particles.count(); ++k) {
      state.particles.component(Field::position, 1)[k] -= fallen;
      state.particles.component(Field::velocity, 1)[k] = -std::sqrt(2.0 * times * 9.81 * fallen);
    }
    const auto found = inspect(state);
    EXPECT_EQ(found.has_value(), times > 2.0) << times;
    if (found) {
      EXPECT_EQ(found->field, "energy gained by all soil");
    }
  }
}

/// Steps until it is thrown; `first` is the step after which a look at every step finds something.
void expect_caught_soon(Scene scene, const std::string& name) {
  Simulation simulation(std::move(scene), {1, {}});
  std::uint64_t first = 0;
  try {
    for (int k = 0; k < 20000; ++k) {
      simulation.step();
      if (first != 0) continue;
      try {
        simulation.require_sound();
      } catch (const SimulationInstability&) {
        first = simulation.last_step().step;
      }
    }
    FAIL() << name << " ran on";
  } catch (const SimulationInstability& error) {
    ASSERT_TRUE(error.what_happened());
    if (first != 0) {
      EXPECT_LE(error.what_happened()->step, first + 100) << name;
    }
  }
}

TEST(WatchTest, ARealBlowUpIsCaughtWithin100Steps) {
  for (const double cfl : {1.0, 2.0}) {
    for (const char* preset_name : {"paper", "modern"}) {
      Scene scene = small_slope(preset_name, 100.0, 1.0, 1.0);
      scene.numerics.integrator = Integrator::verlet;  // unstable from about 1 on
      scene.numerics.cfl = cfl;
      scene.stages[0].damping = 0.0;
      scene.materials = {elastic(100e6)};
      scene.bodies[0].velocity = {0.5, 0.2, 0.0};
      expect_caught_soon(scene, preset_name);
    }
  }
}

TEST(WatchTest, GrainsThatPassAFaceAreNamed) {
  // Smooth wall without stiffness behind it: the block is thrown at 0.8 of its own sound speed.
  Scene scene = elastic_column("modern", 1.0, 0.1);
  scene.materials[0].model.set("youngs_modulus", 1e4);
  scene.stages[0].damping = 0.0;
  State state = make_state(scene, {1, {}});
  for (const Phase& phase :
       phases_of(state.scene.numerics.integrator, state.kernels.corrects_forces()).stage_start)
    phase.run(state);  // lists stand
  watch_walls(state);
  double* y = state.particles.component(Field::position, 1);
  const double before = y[changed];
  y[changed] = -0.049;  // lost from half a spacing on
  watch_walls(state);
  y[changed] = -0.3;
  try {
    watch_walls(state);
    FAIL() << "not found";
  } catch (const SimulationInstability& error) {
    ASSERT_TRUE(error.what_happened());
    EXPECT_EQ(error.what_happened()->field, "depth behind wall 'box'");
    EXPECT_NEAR(error.what_happened()->value, 0.3, 1e-12);
    EXPECT_EQ(error.what_happened()->particle, state.particles.ids()[changed]);
  }
  y[changed] = before;
  // What stood behind the face before has not passed it.
  state.particles.component(Field::build_position, 1)[changed] = -0.3;
  y[changed] = -0.4;
  watch_walls(state);
}

TEST(WatchTest, ALongFallIsNoInstability) {
  Scene scene = elastic_column("modern", 1.0, 0.25);
  scene.materials[0].model.set("youngs_modulus", 1e4);  // c_p = 2.6 m/s
  scene.walls.clear();
  scene.stages = {stage_for("fall", 10.0)};
  Simulation simulation(scene, {1, {}});
  while (!simulation.finished()) simulation.step();
  // Of the beginning of the last step; kick-drift-kick is exact, sums over 1e3 steps are not.
  const StepReport& last = simulation.last_step();
  EXPECT_NEAR(last.max_velocity, 9.81 * (10.0 - last.time_step), 1e-9);
}

TEST(HandledTest, ALoneGrainFallsFreely) {
  for (const char* preset_name : {"paper", "modern"}) {
    Scene scene = small_slope(preset_name, 1.0, 1.0, 1.0);
    scene.bodies = {{.shape = Box{{10, 50, 0}, {11, 51, 0}}}};
    scene.probes.clear();
    scene.stages = {stage_for("fall", 2.0)};
    Simulation simulation(scene, {1, {}});
    ASSERT_EQ(simulation.soil_count(), 1u);
    while (!simulation.finished()) simulation.step();
    // Kick-drift-kick is exact; Verlet's forward steps lose g dt^2/2 each, and dt is 2 ms.
    EXPECT_NEAR(simulation.field("position")[1], 50.5 - 0.5 * 9.81 * 4.0, 0.1);
  }
}

TEST(HandledTest, TwoGrainsAtOnePlaceStayFinite) {
  for (const char* preset_name : {"paper", "modern"}) {
    Scene scene = small_slope(preset_name, 1.0, 1.0, 1.0);
    const Simulation start(scene, {1, {}});
    const Snapshot sound = start.snapshot();
    Snapshot spoiled;
    for (SnapshotItem item : sound.items()) {
      if (item.name == "fields/position") {
        auto& x = std::get<std::vector<double>>(item.values);
        const std::size_t slots = item.shape[1];
        x[changed] = x[changed + 1];
        x[slots + changed] = x[slots + changed + 1];
      }
      spoiled.add(std::move(item));
    }
    Simulation simulation(scene, spoiled, {1, {}});
    for (int k = 0; k < 300; ++k) simulation.step();
    for (const double x : simulation.field("position")) ASSERT_TRUE(std::isfinite(x));
    for (const double s : simulation.field("stress")) ASSERT_TRUE(std::isfinite(s));
  }
}

bool warns(const Scene& scene, const std::string& words) {
  for (const std::string& warning : warnings(scene)) {
    if (warning.find(words) != std::string::npos) return true;
  }
  return false;
}

TEST(HandledTest, AMaterialWithoutBodyIsNamedAndHarmless) {
  Scene scene = small_slope("modern", 0.05, 0.05, 1.0);
  EXPECT_FALSE(warns(scene, "no body is made of it"));
  scene.bodies.front().material = scene.materials.front().name;
  scene.materials.push_back(elastic(1e12));  // would make the step 100 times shorter
  EXPECT_TRUE(warns(scene, "'elastic': no body is made of it"));
  EXPECT_GT(run_steps(scene, 20).last_step().time_step, 1e-3);
}

TEST(HandledTest, AGapIsLookedForAcrossTheEdgesOfFacesIn3D) {
  Scene scene = elastic_column("modern", 2.0, 0.1);
  scene.dimension = 3;
  scene.walls.resize(1);
  scene.walls[0].name = "floor";
  scene.walls.push_back(scene.walls[0]);
  scene.walls[1].name = "side";
  scene.walls[0].facets = {{{}, {1, 0, 0}, {0, 1, 0}, 1.0, 1.0, {0, 0, 1}}};
  scene.walls[1].facets = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1.0, 1.0, {-1, 0, 0}}};
  EXPECT_FALSE(warns(scene, "gap"));
  scene.walls[0].facets[0].length_u = 0.85;
  EXPECT_TRUE(warns(scene, "wall 'floor' ends at (0.85, 0, 0), 0.15 m from wall 'side'"));
  scene.walls[0].facets[0].length_u = 0.5;  // farther than soil reaches: two walls, no gap
  EXPECT_FALSE(warns(scene, "gap"));
}

TEST(HandledTest, AGapBetweenWallsIsNamedAndSoilFallsThrough) {
  Scene scene = elastic_column("modern", 2.0, 0.1);
  EXPECT_FALSE(warns(scene, "gap"));
  scene.walls[0].facets[0] = facet_2d(0, 0, 0.8, 0);
  EXPECT_TRUE(warns(scene, "wall 'box' ends at (0.8, 0), 0.2 m from wall 'box'"));
  scene.materials = {{"sand", DruckerPrager{1e6, 0.3, 0.0, 0.5, 0.0, Cone::plane_strain}, 1600.0}};
  scene.stages = {stage_for("leak", 1.0)};
  Simulation simulation(scene, {1, {}});
  while (!simulation.finished()) simulation.step();
  double lowest = 0.0;
  const auto position = simulation.field("position");
  for (std::size_t k = 1; k < position.size(); k += 3) {
    ASSERT_TRUE(std::isfinite(position[k]));
    lowest = std::min(lowest, position[k]);
  }
  EXPECT_LT(lowest, -1.0);
}

}  // namespace
}  // namespace scarp::test
