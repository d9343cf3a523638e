// SPDX-License-Identifier: BSD-3-Clause
/// What phases say that they read and write is true.
#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "engine/setup.hpp"
#include "engine/step/step_phases.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// Calls use(row, component, array) for what the run stores.
template <class Use>
void each_array(State& state, const Use& use) {
  for (const FieldRow& field : state.particles.rows()) {
    if (field.lifetime == Lifetime::derived) continue;
    for (int c = 0; c < component_count(field.rank); ++c) {
      double* array = state.particles.component(field.field, c);
      if (array != nullptr) use(field, c, array);
    }
  }
}

bool same(const State& a, const State& b, const FieldRow& field, int component) {
  return std::memcmp(a.particles.component(field.field, component),
                     b.particles.component(field.field, component),
                     static_cast<std::size_t>(a.particles.slots()) * sizeof(double)) == 0;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void poison_records(State& state) {
  for (std::int64_t k = 0; k < state.sweep.records.layout().records(); ++k)
    std::fill_n(state.sweep.records.record(k), kernels::record_size, nan);
}

bool same_records(State& a, State& b) {
  const auto bytes = static_cast<std::size_t>(a.sweep.records.layout().records()) *
                     kernels::record_size * sizeof(double);
  return std::memcmp(a.sweep.records.record(0), b.sweep.records.record(0), bytes) == 0;
}

/// Runs the phase on `state` and beside it on a copy in which what it does not name is no number;
/// says what comes out that should not, or nothing.
std::string lies_of(const Phase& phase, State& state) {
  const DataSet named = phase.reads | phase.writes;
  const bool packs = named.has(Part::records);
  State before = state, poisoned = state;
  each_array(poisoned, [&](const FieldRow& field, int, double* array) {
    if (!named.has(field.field)) std::fill_n(array, poisoned.particles.slots(), nan);
  });
  if (!packs) poison_records(poisoned);
  phase.run(state);
  phase.run(poisoned);
  std::string lies;
  each_array(state, [&](const FieldRow& field, int c, double*) {
    const std::string name = std::string(" ") + field.name;
    if (phase.writes.has(field.field)) {
      if (!same(state, poisoned, field, c)) lies += name + " depends on what it does not read;";
    } else if (!same(state, before, field, c)) {
      lies += name + " is written;";
    }
  });
  if (!phase.writes.has(Part::records) && !same_records(state, before))
    lies += " records are written;";
  if (packs && phase.writes.has(Part::records) && !same_records(state, poisoned))
    lies += " records depend on what it does not read;";
  if (!phase.writes.has(Part::lists) && state.neighbours.rebuilds != before.neighbours.rebuilds)
    lies += " lists are built;";
  if (state.clock.time_step != poisoned.clock.time_step ||
      state.neighbours.due != poisoned.neighbours.due ||
      state.stage.damping != poisoned.stage.damping ||
      state.report.max_velocity != poisoned.report.max_velocity ||
      state.ledger.last_powers.stress != poisoned.ledger.last_powers.stress ||
      state.ledger.start.elastic != poisoned.ledger.start.elastic)
    lies += " a number depends on what it does not read;";
  return lies;
}

/// Steps by phases, each looked at: past the watch's look at every 50th, and into the next stage.
void expect_no_lies(const Scene& scene) {
  State state = make_state(scene, {1, {}});
  const StepPhases phases = phases_of(scene.numerics.integrator, state.kernels.corrects_forces());
  std::size_t stages = 0;
  const auto run = [&](PhaseList list) {
    for (const Phase& phase : list) ASSERT_EQ(lies_of(phase, state), "") << phase.name;
  };
  for (int step = 0; step < 70; ++step) {
    if (!state.stage.started || state.stage.ended) {
      ASSERT_NO_FATAL_FAILURE(run(phases.stage_start));
      ++stages;
    }
    ASSERT_NO_FATAL_FAILURE(run(phases.step)) << "step " << step;
    if (step == 55) state.stage.ended = true;
  }
  EXPECT_EQ(stages, 2u);
  EXPECT_GT(state.neighbours.rebuilds, 1u);
}

TEST(PhaseTest, ReadsAndWritesAreAsDeclared) {
  for (const char* name : {"paper", "modern"}) {
    for (const Integrator integrator : {Integrator::verlet, Integrator::kick_drift_kick}) {
      Scene scene = small_slope(name, 10.0, 10.0, 1.6);
      scene.spacing = 2.5;
      scene.numerics.integrator = integrator;
      scene.numerics.cfl = integrator == Integrator::verlet ? 0.2 : 0.5;
      scene.numerics.skin = 0.02;  // lists are built anew soon
      scene.materials[0].model.set("youngs_modulus", 10e6);
      scene.output.energy = true;
      scene.walls[2].velocity = {0.5, 0.0, 0.0};
      ASSERT_NO_FATAL_FAILURE(expect_no_lies(scene)) << name << static_cast<int>(integrator);
      if (scene.numerics.gradient_correction) {
        scene.numerics.force_correction = true;
        scene.numerics.hourglass_viscosity = 0.1;
        ASSERT_NO_FATAL_FAILURE(expect_no_lies(scene))
            << "corrected" << static_cast<int>(integrator);
      }
    }
  }
}

TEST(PhaseTest, ReadsAndWritesAreAsDeclaredIn3DAndMixedPrecision) {
  Scene scene = small_collapse("modern", 0.04, 1.0);
  scene.numerics.precision = Precision::mixed;
  scene.numerics.skin = 0.02;
  scene.stages[0].duration = 1.0;
  scene.output.energy = true;
  ASSERT_NO_FATAL_FAILURE(expect_no_lies(scene));
  scene.numerics.force_correction = true;
  scene.numerics.hourglass_viscosity = 0.1;
  ASSERT_NO_FATAL_FAILURE(expect_no_lies(scene));
}

/// So that the test above can fail.
TEST(PhaseTest, ALieIsFound) {
  const Scene scene = small_slope("modern", 1.0, 1.0, 1.0);
  State state = make_state(scene, {1, {}});
  for (const Phase& phase : phases_of(Integrator::kick_drift_kick, false).stage_start)
    phase.run(state);
  choose_time_step(state);
  Phase kick = phases::kick_half;
  State copy = state;
  EXPECT_EQ(lies_of(kick, copy), "");
  kick.reads = Field::velocity;
  copy = state;
  EXPECT_NE(lies_of(kick, copy), "");
  kick = phases::kick_half;
  kick.writes = Field::density;
  kick.reads = {Field::velocity, Field::acceleration};
  copy = state;
  EXPECT_NE(lies_of(kick, copy), "");
  Phase pack = phases::pack_soil;
  pack.writes = {};
  pack.reads = pack.reads | DataSet(Part::records);
  kick_half(state);
  drift_half(state);
  EXPECT_NE(lies_of(pack, state), "");
}

}  // namespace
}  // namespace scarp::test
