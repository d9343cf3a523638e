// SPDX-License-Identifier: BSD-3-Clause
/// What is left out of the walls beside sleeping soil is read by nobody.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "engine/setup.hpp"
#include "engine/step/step_phases.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

void step(State& state, const StepPhases& phases) {
  if (!state.stage.started || state.stage.ended)
    for (const Phase& phase : phases.stage_start) phase.run(state);
  for (const Phase& phase : phases.step) phase.run(state);
}

/// Records are packed of all soil in the next step, and all dummies sum.
State with_nothing_left_out(const State& state) {
  State all = state;
  const auto clusters = all.neighbours.wall_lists.active_clusters();
  const auto columns = all.boundary.walls.columns().active();
  for (SleepReads* reads : {&all.sleep.awake_reads, &all.sleep.edge_reads}) {
    reads->soil = reads->packed = SlotRanges();
    reads->wall_clusters.assign(clusters.begin(), clusters.end());
    reads->wall_columns.assign(columns.begin(), columns.end());
    reads->images = {};
  }
  return all;
}

bool same_motion(const State& a, const State& b) {
  for (const Field field : {Field::position, Field::velocity, Field::stress, Field::acceleration}) {
    const int components = field == Field::stress ? 6 : 3;
    for (int c = 0; c < components; ++c) {
      const double *one = a.particles.component(field, c), *other = b.particles.component(field, c);
      if (one == nullptr || other == nullptr) continue;
      if (std::memcmp(one, other, static_cast<std::size_t>(a.particles.slots()) * sizeof(double)) !=
          0)
        return false;
    }
  }
  return true;
}

/// A bed 40 m long in a smooth box on rough ground, and a heap at its left end that slumps.
Scene slumping_heap(Integrator integrator) {
  Scene scene;
  scene.spacing = 0.2;
  scene.numerics = preset("modern");
  scene.numerics.sleep = 0.06;
  scene.numerics.integrator = integrator;
  scene.numerics.cfl = integrator == Integrator::verlet ? 0.2 : 0.8;
  scene.materials = {
      {"sand", DruckerPrager{2e6, 0.3, 500.0, 0.576, 0.0, Cone::plane_strain}, 1600.0}};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {40, 1, 0}}}, {.shape = Box{{0, 1, 0}, {2, 3, 0}}}};
  scene.walls = {
      wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 40, 0)}),
      wall_of("sides", WallKind::free_slip, {facet_2d(40, 0, 40, 5), facet_2d(0, 5, 0, 0)})};
  scene.initial_stress = InitialStress::geostatic;
  scene.stages = {stage_for("slump", 4.0)};
  return scene;
}

TEST(SleepWallsTest, DummiesThatAreNotSummedAreReadByNobody) {
  for (const Integrator integrator : {Integrator::verlet, Integrator::kick_drift_kick}) {
    State state = make_state(slumping_heap(integrator), {1, {}});
    const StepPhases phases = phases_of(integrator, state.kernels.corrects_forces());
    int looked_at = 0;
    std::size_t left_out = 0;
    for (int k = 0; k < 4000 && looked_at < 200; ++k) {
      if (state.sleep.any() && k % 4 == 0) {
        State all = with_nothing_left_out(state);
        left_out += all.sleep.awake_reads.wall_clusters.size() -
                    state.sleep.awake_reads.wall_clusters.size();
        step(all, phases);
        step(state, phases);
        ASSERT_TRUE(same_motion(state, all))
            << "step " << k << ", " << static_cast<int>(integrator);
        ++looked_at;
      } else {
        step(state, phases);
      }
    }
    EXPECT_EQ(looked_at, 200);
    EXPECT_GT(left_out, 0U);
  }
}

/// What `change_at_edge` rests on: a stress that changes by S on one side of a plane gives the row
/// beside it f of S/(2 rho h) or more.
TEST(SleepWallsTest, AStressThatChangesOnOneSideGivesTheRowBesideItHalfOfItOverH) {
  for (const SmoothingFunction smoothing :
       {SmoothingFunction::cubic_spline, SmoothingFunction::wendland_c2}) {
    for (const double ratio : {1.0, 1.2, 2.0}) {
      Scene scene = slumping_heap(Integrator::kick_drift_kick);
      scene.bodies = {{.shape = Box{{0, 0, 0}, {8, 8, 0}}}};
      scene.walls.clear();
      scene.initial_stress = InitialStress::zero;
      scene.numerics.smoothing = smoothing;
      scene.numerics.smoothing_ratio = ratio;
      State state = make_state(scene, {1, {}});
      const StepPhases phases = phases_of(Integrator::kick_drift_kick, true);
      for (const Phase& phase : phases.stage_start) phase.run(state);
      const double change = 1e3;
      const auto is_middle = [&](std::int64_t k) {
        return std::abs(state.particles.component(Field::position, 0)[k] - 4.0) < 1.0;
      };
      const double* y = state.particles.component(Field::position, 1);
      double* stress = state.particles.component(Field::stress, 1);
      for (std::int64_t k = 0; k < state.particles.count(); ++k) {
        if (y[k] > 4.0) stress[k] -= change;
      }
      for (const Phase& phase : phases.renewal) phase.run(state);
      int rows = 0;
      y = state.particles.component(Field::position, 1);
      for (std::int64_t k = 0; k < state.particles.count(); ++k) {
        if (!is_middle(k) || y[k] > 4.0 || y[k] < 4.0 - scene.spacing) continue;
        ++rows;
        const double f = -state.particles.component(Field::acceleration, 1)[k];
        const double share = f * 1600.0 * state.smoothing_length / change;
        EXPECT_GE(share, 0.5 - 1e-9) << ratio;
        EXPECT_LE(share, 0.7) << ratio;
      }
      EXPECT_EQ(rows, 10);
    }
  }
}

}  // namespace
}  // namespace scarp::test
