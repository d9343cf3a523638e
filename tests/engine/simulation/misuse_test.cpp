// SPDX-License-Identifier: BSD-3-Clause
/// What a program may do wrong with the library: an error of a type it can catch, never a crash.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "engine/errors.hpp"
#include "engine/scene/scene.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp {
namespace {

using test::small_slope;

Scene slope() { return small_slope("modern", 0.1, 0.1, 1.2); }

struct Use {
  const char* name;
  std::function<void(Simulation&)> call;
};

void no_hook(PhaseView& /*view*/) {}

/// Every public member, on any object.
std::vector<Use> every_use() {
  return {
      {"step", [](Simulation& s) { s.step(); }},
      {"finished", [](Simulation& s) { static_cast<void>(s.finished()); }},
      {"end_stage", [](Simulation& s) { s.end_stage(); }},
      {"set_following_stages", [](Simulation& s) { s.set_following_stages({}); }},
      {"set_step_factor", [](Simulation& s) { s.set_step_factor(0.5); }},
      {"step_factor", [](Simulation& s) { static_cast<void>(s.step_factor()); }},
      {"perturb", [](Simulation& s) { s.perturb(1e-3); }},
      {"clone", [](Simulation& s) { static_cast<void>(s.clone()); }},
      {"snapshot", [](Simulation& s) { static_cast<void>(s.snapshot()); }},
      {"scene", [](Simulation& s) { static_cast<void>(s.scene()); }},
      {"last_step", [](Simulation& s) { static_cast<void>(s.last_step()); }},
      {"stage_index", [](Simulation& s) { static_cast<void>(s.stage_index()); }},
      {"stage_ended", [](Simulation& s) { static_cast<void>(s.stage_ended()); }},
      {"stage_reached_rest", [](Simulation& s) { static_cast<void>(s.stage_reached_rest()); }},
      {"soil_count", [](Simulation& s) { static_cast<void>(s.soil_count()); }},
      {"wall_count", [](Simulation& s) { static_cast<void>(s.wall_count()); }},
      {"fields", [](Simulation& s) { static_cast<void>(s.fields()); }},
      {"field", [](Simulation& s) { static_cast<void>(s.field("stress")); }},
      {"wall_positions", [](Simulation& s) { static_cast<void>(s.wall_positions()); }},
      {"wall_faces", [](Simulation& s) { static_cast<void>(s.wall_faces()); }},
      {"require_sound", [](Simulation& s) { s.require_sound(); }},
      {"energy", [](Simulation& s) { static_cast<void>(s.energy()); }},
      {"wall_reactions", [](Simulation& s) { static_cast<void>(s.wall_reactions()); }},
      {"view", [](Simulation& s) { static_cast<void>(s.view("velocity")); }},
      {"set_field", [](Simulation& s) { s.set_field("velocity", s.field("velocity")); }},
      {"probe", [](Simulation& s) { static_cast<void>(s.probe(0)); }},
      {"probe by name", [](Simulation& s) { static_cast<void>(s.probe("crest")); }},
      {"smoothing_length", [](Simulation& s) { static_cast<void>(s.smoothing_length()); }},
      {"acoustic_cfl_limit", [](Simulation& s) { static_cast<void>(s.acoustic_cfl_limit()); }},
      {"lattice_moment", [](Simulation& s) { static_cast<void>(s.lattice_moment()); }},
      {"isa", [](Simulation& s) { static_cast<void>(s.isa()); }},
      {"threads", [](Simulation& s) { static_cast<void>(s.threads()); }},
      {"options", [](Simulation& s) { static_cast<void>(s.options()); }},
      {"memory_bytes", [](Simulation& s) { static_cast<void>(s.memory_bytes()); }},
      {"rebuild_count", [](Simulation& s) { static_cast<void>(s.rebuild_count()); }},
      {"density_bound_count", [](Simulation& s) { static_cast<void>(s.density_bound_count()); }},
      {"step_limit_counts", [](Simulation& s) { static_cast<void>(s.step_limit_counts()); }},
      {"face_hold_count", [](Simulation& s) { static_cast<void>(s.face_hold_count()); }},
      {"features", [](Simulation& s) { static_cast<void>(s.features()); }},
      {"profile", [](Simulation& s) { static_cast<void>(s.profile()); }},
      {"phases", [](Simulation& s) { static_cast<void>(s.phases()); }},
      {"on_phase", [](Simulation& s) { s.on_phase("watch", When::after, no_hook); }}};
}

// Before any step, too: programs ask in any order.
TEST(MisuseTest, EveryMemberWorksBeforeTheFirstStep) {
  for (const Use& use : every_use()) {
    Simulation simulation(slope());
    EXPECT_NO_THROW(use.call(simulation)) << use.name;
  }
}

TEST(MisuseTest, EveryMemberOfAMovedFromObjectThrows) {
  Simulation old(slope());
  Simulation now = std::move(old);
  for (const Use& use : every_use()) EXPECT_THROW(use.call(old), Error) << use.name;
  EXPECT_NO_THROW(now.step());
  old = std::move(now);  // assigned to, it lives again
  EXPECT_NO_THROW(old.step());
  EXPECT_THROW(now.step(), Error);
}

TEST(MisuseTest, ArgumentsThatMakeNoSenseAreTold) {
  Simulation simulation(slope());
  const double infinite = std::numeric_limits<double>::infinity(), nan = std::nan("");
  for (const double factor : {0.0, -1.0, infinite, nan}) {
    EXPECT_THROW(simulation.set_step_factor(factor), Error) << factor;
  }
  EXPECT_EQ(simulation.step_factor(), 1.0);
  for (const double speed : {infinite, nan}) EXPECT_THROW(simulation.perturb(speed), Error);
  for (const std::size_t index : {std::size_t{1}, std::size_t{5}, ~std::size_t{0}}) {
    EXPECT_THROW(static_cast<void>(simulation.probe(index)), Error) << index;
  }
  for (const char* name : {"", "no_such_field", "velocity_gradient"}) {
    EXPECT_THROW(static_cast<void>(simulation.field(name)), Error) << name;
  }
  Stage endless;
  endless.name = "endless";
  endless.duration = nan;
  EXPECT_THROW(simulation.set_following_stages({endless}), Error);
  EXPECT_EQ(simulation.scene().stages.size(), 2u);
  EXPECT_THROW(Simulation(slope(), {0, "avx1024"}), SceneError);
  EXPECT_THROW(Simulation(slope(), Snapshot()), CheckpointError);
  EXPECT_STREQ(name_of(static_cast<StepLimit>(-1)), "unknown");
  EXPECT_STREQ(name_of(static_cast<StepLimit>(7)), "unknown");
}

TEST(MisuseTest, EnumeratorsOutOfRangeAreSceneErrors) {
  const std::vector<std::pair<const char*, std::function<void(Scene&, int)>>> choices{
      {"numerics.smoothing",
       [](Scene& s, int v) { s.numerics.smoothing = static_cast<SmoothingFunction>(v); }},
      {"numerics.stress_rotation",
       [](Scene& s, int v) { s.numerics.stress_rotation = static_cast<StressRotation>(v); }},
      {"numerics.integrator",
       [](Scene& s, int v) { s.numerics.integrator = static_cast<Integrator>(v); }},
      {"numerics.precision",
       [](Scene& s, int v) { s.numerics.precision = static_cast<Precision>(v); }},
      {"initial.stress", [](Scene& s, int v) { s.initial_stress = static_cast<InitialStress>(v); }},
      {"wall[1].kind", [](Scene& s, int v) { s.walls[1].kind = static_cast<WallKind>(v); }},
      {"stage[1].until", [](Scene& s, int v) { s.stages[1].until = static_cast<StageEnd>(v); }},
      {"body[0].height_field", [](Scene& s, int v) {
         HeightField field;
         field.kind = static_cast<HeightField::Kind>(v);
         s.bodies[0].shape = field;
       }}};
  for (const auto& [key, set] : choices) {
    for (const int value : {-1, 7, 2147483647}) {
      Scene scene = slope();
      set(scene, value);
      try {
        Simulation simulation(scene);
        ADD_FAILURE() << key << " = " << value << " is taken";
      } catch (const SceneError& error) {
        EXPECT_NE(std::string(error.what()).find(key), std::string::npos) << error.what();
      }
    }
  }
  for (const int value : {-1, 3, 2147483647})
    EXPECT_EQ(word(static_cast<StressRotation>(value)), "unknown");
  EXPECT_EQ(word(StressRotation::hughes_winget), "hughes_winget");
}

}  // namespace
}  // namespace scarp
