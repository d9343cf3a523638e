// SPDX-License-Identifier: BSD-3-Clause
/// A run that goes on from a snapshot is the run that was never stopped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <ostream>

#include "engine/errors.hpp"
#include "engine/simulation.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp {
namespace {

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

/// Every item of the state, hidden ones included.
void expect_equal_states(const Simulation& a, const Simulation& b) {
  const Snapshot first = a.snapshot(), second = b.snapshot();
  ASSERT_EQ(first.items().size(), second.items().size());
  for (std::size_t k = 0; k < first.items().size(); ++k) {
    const SnapshotItem &one = first.items()[k], &other = second.items()[k];
    ASSERT_EQ(one.name, other.name);
    EXPECT_EQ(one.shape, other.shape) << one.name;
    if (const auto* numbers = std::get_if<std::vector<double>>(&one.values)) {
      EXPECT_TRUE(same_bits(*numbers, std::get<std::vector<double>>(other.values))) << one.name;
    } else {
      EXPECT_EQ(one.values, other.values) << one.name;
    }
  }
  for (const FieldInfo& field : a.fields()) {
    EXPECT_TRUE(same_bits(a.field(field.name), b.field(field.name))) << field.name;
  }
  EXPECT_TRUE(same_bits(a.wall_positions(), b.wall_positions()));
  EXPECT_EQ(a.rebuild_count(), b.rebuild_count());
}

void advance(Simulation& simulation, int steps) {
  for (int k = 0; k < steps && !simulation.finished(); ++k) simulation.step();
}

/// Sand that collapses in 3D behind a gate that goes, and a rough wall that is driven into it.
Scene collapse(const std::string& name) {
  Scene scene = test::small_collapse(name, 0.02, 0.2);
  scene.stages[0].duration = 2e-3;
  scene.walls[0].velocity = {0.3, 0.0, 0.05};
  scene.walls[0].moves_from = "collapse";
  return scene;
}

/// A gate of dummies that is pulled up, so that a wall's offset is not that of its placing.
Scene moving_then_removed(const std::string& name) {
  Scene scene = collapse(name);
  scene.walls[0].moves_from.clear();
  scene.walls[2].kind = WallKind::no_slip;
  return scene;
}

Scene slope(const std::string& name) {
  Scene scene = test::small_slope(name, 0.02, 2.0, 1.6);
  scene.output.energy = true;
  scene.numerics.skin = 0.002;  // lists are built again every few steps
  return scene;
}

Scene thrown(const std::string& name, Integrator integrator) {
  Scene scene = slope(name);
  scene.numerics.integrator = integrator;
  if (integrator == Integrator::verlet) scene.numerics.cfl = 0.2;  // at 1 it blows up
  scene.bodies[0].velocity = {2.0, 0.5, 0.0};
  return scene;
}

struct Case {
  std::string name;
  std::function<Scene()> scene;
};

void PrintTo(const Case& scene, std::ostream* out) { *out << scene.name; }

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const std::string preset : {"paper", "modern"}) {
    all.push_back({"slope_" + preset, [=] { return slope(preset); }});
    all.push_back({"collapse_" + preset, [=] { return collapse(preset); }});
    all.push_back({"gate_" + preset, [=] { return moving_then_removed(preset); }});
    all.push_back({"verlet_" + preset, [=] { return thrown(preset, Integrator::verlet); }});
    all.push_back({"kick_" + preset, [=] { return thrown(preset, Integrator::kick_drift_kick); }});
    all.push_back({"flying_" + preset, [=] {
                     Scene scene = test::bed_and_grain(preset);
                     scene.numerics.skin = 0.05;
                     scene.stages = {test::stage_for("fall", 0.02), test::stage_for("lie", 10.0)};
                     return scene;
                   }});
    all.push_back({"mixed_" + preset, [=] {
                     Scene scene = collapse(preset);
                     scene.numerics.precision = Precision::mixed;
                     return scene;
                   }});
  }
  return all;
}

class SnapshotTest : public testing::TestWithParam<Case> {};

TEST_P(SnapshotTest, GoesOnBitForBitAtAnyMoment) {
  constexpr int steps = 90;
  RunOptions one, three;
  one.threads = 1;
  three.threads = 3;
  three.oversubscribe = true;
  const Scene scene = GetParam().scene();
  Simulation whole(scene, one);
  advance(whole, steps);
  // The stage changes on the way: before, at and after it, and right after lists were built.
  ASSERT_GT(whole.stage_index(), 0u);
  ASSERT_GT(whole.rebuild_count(), 2u);
  Simulation running(scene, one);
  for (int done = 0; done < steps;) {
    Simulation resumed(scene, running.snapshot(), three);
    expect_equal_states(running, resumed);
    advance(resumed, steps - done);
    expect_equal_states(whole, resumed);
    if (HasFailure()) FAIL() << "resumed after " << done << " steps";
    const int next = done < 2 ? 1 : 11;
    advance(running, next);
    done += next;
  }
}

TEST_P(SnapshotTest, ChangesNothing) {
  const Scene scene = GetParam().scene();
  Simulation watched(scene), alone(scene);
  for (int k = 0; k < 20; ++k) {
    watched.step();
    (void)watched.snapshot();
    alone.step();
  }
  expect_equal_states(watched, alone);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SnapshotTest, testing::ValuesIn(cases()),
                         [](const auto& scene) { return scene.param.name; });

TEST(Snapshot, SurvivesTheEndOfAStageAtEachStepAroundIt) {
  const Scene scene = collapse("modern");
  Simulation running(scene);
  while (!running.stage_ended()) running.step();
  Simulation whole = running.clone();
  advance(whole, 30);
  Simulation resumed(scene, running.snapshot());
  EXPECT_TRUE(resumed.stage_ended());
  advance(resumed, 30);
  expect_equal_states(whole, resumed);
}

TEST(Snapshot, GoesOnFromAFamilyOfStages) {
  Simulation first = test::run_steps(slope("modern"), 10);
  first.set_following_stages({test::stage_for("other", 0.5)});
  Simulation resumed(first.scene(), first.snapshot());
  advance(first, 40);
  advance(resumed, 40);
  expect_equal_states(first, resumed);
}

TEST(Snapshot, IsRefusedByAnotherScene) {
  const Scene scene = slope("modern");
  const Snapshot snapshot = test::run_steps(scene, 3).snapshot();
  const auto refused = [&](const std::function<void(Scene&)>& change, const std::string& word) {
    Scene other = scene;
    change(other);
    try {
      Simulation simulation(other, snapshot);
      ADD_FAILURE() << "accepted in spite of " << word;
    } catch (const CheckpointError& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  refused([](Scene& s) { s.numerics.cfl = 0.5; }, "numerics.cfl = 0.8, here numerics.cfl = 0.5");
  refused([](Scene& s) { s.materials[0].model.set("cohesion", 1.0); }, "material[0].parameters");
  refused([](Scene& s) { s.spacing *= 2.0; }, "spacing");
  refused([](Scene& s) { s.stages.pop_back(); }, "stage[1].name = fail, here nothing");
  refused([](Scene& s) { s.walls[0].velocity = {1, 0, 0}; }, "wall[0].velocity");
  Scene renamed = scene;  // what does not move a particle may change
  renamed.title = "another title";
  renamed.output.frame_interval = 0.1;
  EXPECT_NO_THROW(Simulation(renamed, snapshot));
}

/// With one item changed.
template <class Values>
Snapshot changed(const Snapshot& whole, const std::string& name,
                 const std::function<void(Values&)>& change) {
  Snapshot other;
  for (SnapshotItem item : whole.items()) {
    if (item.name == name) change(std::get<Values>(item.values));
    other.add(std::move(item));
  }
  return other;
}
using Numbers = std::vector<double>;
using Integers = std::vector<std::int64_t>;

void expect_refused(const Scene& scene, const Snapshot& snapshot, const std::string& word) {
  try {
    Simulation simulation(scene, snapshot, {1, {}});
    ADD_FAILURE() << "accepted in spite of " << word;
  } catch (const CheckpointError& error) {
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(Snapshot, IsRefusedWithAValueThatIsNotFinite) {
  const Scene scene = slope("modern");
  const Snapshot whole = test::run_steps(scene, 3).snapshot();
  for (const SnapshotItem& item : whole.items()) {
    if (!std::holds_alternative<Numbers>(item.values)) continue;
    for (const double bad : {std::nan(""), -HUGE_VAL}) {
      for (const bool last : {false, true}) {
        const auto change = [&](Numbers& v) { (last ? v.back() : v.front()) = bad; };
        expect_refused(scene, changed<Numbers>(whole, item.name, change), item.name);
      }
    }
  }
}

TEST(Snapshot, IsRefusedWithAValueOutOfItsRange) {
  const Scene scene = slope("modern");
  const Snapshot whole = test::run_steps(scene, 3).snapshot();
  const std::vector<std::pair<std::string, std::vector<double>>> numbers{
      {"clock/step_factor", {0.0, -1.0, 1e-300, 1e300}},
      {"clock/time", {-1.0}},
      {"clock/time_step", {-1e-3}},
      {"clock/growth_base", {-1.0}},
      {"clock/stage_time", {-1.0, 1e9}},
      {"stage/damping", {-1.0}},
      {"stage/start_speed", {-1.0}},
      {"lists/walls_moved", {-1.0}}};
  for (const auto& [name, values] : numbers) {
    for (const double bad : values)
      expect_refused(scene, changed<Numbers>(whole, name, [&](Numbers& v) { v[0] = bad; }), name);
  }
  const std::int64_t huge = std::int64_t{1} << 40;
  const std::vector<std::pair<std::string, Integers>> integers{
      {"stage/index", {-1, 2, huge}},
      {"report/limit", {-1, 8, huge}},
      {"clock/since_restart", {-1, huge}},
      {"report/signal_material", {-1, 1, huge}},
      {"clock/restart", {-1, 2}},
      {"stage/ended", {2}},
      {"clock/step", {-1}},
      {"counts/density_bounds", {-1}}};
  for (const auto& [name, values] : integers) {
    for (const std::int64_t bad : values)
      expect_refused(scene, changed<Integers>(whole, name, [&](Integers& v) { v[0] = bad; }), name);
  }
}

TEST(Snapshot, IsRefusedWithAStateThatNoSoilCanBeIn) {
  const Scene scene = slope("modern");
  const Snapshot whole = test::run_steps(scene, 3).snapshot();
  const auto with = [&](const std::string& name, double value) {
    return changed<Numbers>(whole, name, [&](Numbers& v) { v[0] = value; });
  };
  for (const double far : {1e300, -1e12}) {
    expect_refused(scene, with("fields/position", far), "out of reach");
    expect_refused(scene, with("fields/build_position", far), "out of reach");
  }
  expect_refused(scene, with("fields/velocity", 1e6), "speed");
  expect_refused(scene, with("fields/density", -5.0), "density");
  expect_refused(scene, with("fields/density", 1e9), "density");
  const auto padding = [&](Integers& ids) {
    const auto place = std::find(ids.begin(), ids.end(), -1);
    ASSERT_NE(place, ids.end());
    *place = 0;
  };
  expect_refused(scene, changed<Integers>(whole, "particles/id", padding), "particles/id");
  expect_refused(scene, changed<Integers>(whole, "particles/id", [](Integers& v) { v.pop_back(); }),
                 "particles/id");
}

TEST(Snapshot, GoesOnThroughMoreStagesThanItWasTakenWith) {
  Scene scene = test::elastic_column("modern", 1.0, 0.1);
  scene.stages = {test::stage_for("load", 0.01)};
  Simulation first(scene, {1, {}});
  advance(first, 100000);
  ASSERT_TRUE(first.finished());
  scene.stages.push_back(test::stage_for("on", 0.01));
  Simulation whole(scene, {1, {}}), longer(scene, first.snapshot(), {1, {}});
  EXPECT_FALSE(longer.finished());
  advance(longer, 100000);
  advance(whole, 100000);
  expect_equal_states(whole, longer);
  scene.stages[0].duration = 2.0 * scene.stages[0].duration.value();
  EXPECT_THROW(Simulation(scene, first.snapshot()), CheckpointError);
}

TEST(Snapshot, IsRefusedWithoutAnItemOrWithParticlesMixedUp) {
  const Scene scene = slope("modern");
  const Snapshot whole = test::run_steps(scene, 3).snapshot();
  for (std::size_t left_out = 0; left_out < whole.items().size(); ++left_out) {
    Snapshot part;
    for (std::size_t k = 0; k < whole.items().size(); ++k) {
      if (k != left_out) part.add(whole.items()[k]);
    }
    EXPECT_THROW(Simulation(scene, part), CheckpointError) << whole.items()[left_out].name;
  }
  Snapshot mixed;
  for (SnapshotItem item : whole.items()) {
    if (item.name == "particles/id") {
      auto& ids = std::get<std::vector<std::int64_t>>(item.values);
      ids[0] = ids[1];
    }
    mixed.add(std::move(item));
  }
  EXPECT_THROW(Simulation(scene, mixed), CheckpointError);
}

}  // namespace
}  // namespace scarp
