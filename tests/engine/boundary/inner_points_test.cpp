// SPDX-License-Identifier: BSD-3-Clause
/// What the sweeps read of the inner points of rough walls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string_view>

#include "engine/boundary/boundary.hpp"
#include "engine/setup.hpp"
#include "engine/state.hpp"
#include "engine/step/step_phases.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

Scene scene_of(int dimension, Precision precision) {
  Scene scene =
      dimension == 2 ? small_slope("modern", 1.0, 1.0, 1.0) : small_collapse("modern", 0.04, 1.0);
  scene.numerics.precision = precision;
  return scene;
}

/// The state just before the last run of a phase in a step.
State before(const Scene& scene, std::string_view phase, int steps) {
  State state = make_state(scene, {1, {}});
  const StepPhases phases = phases_of(scene.numerics.integrator, state.kernels.corrects_forces());
  for (const Phase& one : phases.stage_start) one.run(state);
  for (int k = 0; k + 1 < steps; ++k) {
    for (const Phase& one : phases.step) one.run(state);
  }
  for (const Phase& one : phases.step) {
    if (one.name == phase) break;
    one.run(state);
  }
  return state;
}

void poison_inner_points(State& state) {
  const RecordRange& inner = state.sweep.records.layout()[Role::inner];
  ASSERT_GT(inner.slots, 0);
  for (std::int64_t k = 0; k < inner.slots; ++k)
    std::fill_n(state.sweep.records.record(Role::inner, k), kernels::record_size,
                std::numeric_limits<double>::quiet_NaN());
}

bool same(const State& a, const State& b, Field field) {
  for (int c = 0; c < 3; ++c) {
    const double *one = a.particles.component(field, c), *other = b.particles.component(field, c);
    if (one == nullptr) continue;
    if (std::memcmp(one, other, static_cast<std::size_t>(a.particles.slots()) * sizeof(double)) !=
        0)
      return false;
  }
  return true;
}

TEST(InnerPointsTest, NoForceIsSummedOverThem) {
  for (const int dimension : {2, 3}) {
    for (const Precision precision : {Precision::real64, Precision::mixed}) {
      State state = before(scene_of(dimension, precision), "sweep_force", 5);
      State poisoned = state;
      ASSERT_NO_FATAL_FAILURE(poison_inner_points(poisoned));
      sweep_force(state);
      sweep_force(poisoned);
      EXPECT_TRUE(same(state, poisoned, Field::acceleration)) << dimension;
      const std::vector<WallReaction> a = wall_reactions(state), b = wall_reactions(poisoned);
      for (std::size_t w = 0; w < a.size(); ++w) EXPECT_EQ(a[w].force, b[w].force) << a[w].wall;
    }
  }
}

/// So that the test above can fail.
TEST(InnerPointsTest, GradientsAre) {
  for (const int dimension : {2, 3}) {
    State state = before(scene_of(dimension, Precision::real64), "sweep_gradient", 5);
    State poisoned = state;
    ASSERT_NO_FATAL_FAILURE(poison_inner_points(poisoned));
    sweep_gradient(state);
    sweep_gradient(poisoned);
    EXPECT_FALSE(same(state, poisoned, Field::velocity_gradient)) << dimension;
  }
}

TEST(InnerPointsTest, ListsOfWallsThatHaveGoneAreEmpty) {
  Scene scene = scene_of(2, Precision::mixed);
  scene.walls[0].removed_at = "fail";
  State state = make_state(scene, {1, {}});
  const StepPhases phases = phases_of(scene.numerics.integrator, state.kernels.corrects_forces());
  for (const Phase& one : phases.stage_start) one.run(state);
  for (const Phase& one : phases.step) one.run(state);
  EXPECT_FALSE(state.neighbours.wall_lists.active_clusters().empty());
  state.stage.ended = true;
  for (const Phase& one : phases.stage_start) one.run(state);
  for (const Phase& one : phases.step) one.run(state);
  ASSERT_EQ(state.boundary.walls.count(), 0);
  EXPECT_TRUE(state.neighbours.wall_lists.active_clusters().empty());
}

}  // namespace
}  // namespace scarp::test
