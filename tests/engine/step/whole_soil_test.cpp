// SPDX-License-Identifier: BSD-3-Clause
/// What parts hold, put together, is what the whole holds; and a part that leads says what it
/// calls.
#include "engine/step/whole_soil.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/setup.hpp"
#include "engine/simulation.hpp"
#include "engine/state.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// Keeps what a part gives.
class Recorder : public Reduction {
 public:
  void sum(std::span<double> values) override { values[0] += 1.0; }  // there is another
  void collect(std::vector<double>& values) override { given.push_back(values); }
  bool leads() const override { return false; }
  std::vector<std::vector<double>> given;
};
/// Gives that to the part that leads.
class Player : public Reduction {
 public:
  explicit Player(const Recorder& other) : other_(other) {}
  void sum(std::span<double> values) override { values[0] += 1.0; }
  void collect(std::vector<double>& values) override {
    const std::vector<double>& more = other_.given.at(next_++);
    values.insert(values.end(), more.begin(), more.end());
  }

 private:
  const Recorder& other_;
  std::size_t next_ = 0;
};

ParticleBuffers soil_of_two_materials() {
  Scene scene = small_slope("modern", 1.0, 1.0, 1.0);
  scene.materials.push_back(elastic());
  scene.bodies[0].material = "clay";
  scene.bodies.push_back({.shape = Box{{50, 0, 0}, {55, 5, 0}}, .material = "elastic"});
  ParticleBuffers soil = make_state(scene, {1, {}}).particles;
  for (const ParticleGroup& group : soil.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k)
      soil.component(Field::velocity, 1)[k] = 0.5 * static_cast<double>(k);
  }
  return soil;
}

/// The particles of every third slot, or the others.
ParticleBuffers part_of(ParticleBuffers soil, bool thirds) {
  std::vector<std::int64_t> removed;
  for (const ParticleGroup& group : soil.groups()) {
    for (std::int64_t k = group.first; k < group.end(); ++k) {
      if ((k % 3 == 0) != thirds) removed.push_back(k);
    }
  }
  soil.remove(removed);
  return soil;
}

bool is_state(const FieldRow& field) { return field.lifetime == Lifetime::state; }

TEST(WholeSoilTest, IsThatOfAllParts) {
  const ParticleBuffers all = soil_of_two_materials();
  const ParticleBuffers first = part_of(all, true), second = part_of(all, false);
  ASSERT_EQ(first.count() + second.count(), all.count());
  Reduction alone;
  const std::vector<std::int64_t> lost;
  const auto collected = [&](const auto& call) {
    Recorder recorder;
    call(second, recorder);
    Player player(recorder);
    return call(first, player);
  };
  EXPECT_EQ(
      collected([](const ParticleBuffers& own, Reduction& parts) { return whole_ids(own, parts); }),
      whole_ids(all, alone));
  for (const Field field : {Field::position, Field::velocity, Field::density, Field::id}) {
    EXPECT_EQ(collected([&](const ParticleBuffers& own, Reduction& parts) {
                return whole_field({own, lost}, row(field), parts);
              }),
              whole_field({all, lost}, row(field), alone));
  }
  EXPECT_FALSE(whole_soil(all, is_state, alone).has_value());
  const std::optional<ParticleBuffers> whole =
      collected([](const ParticleBuffers& own, Reduction& parts) {
        return whole_soil(own, is_state, parts);
      });
  ASSERT_TRUE(whole.has_value());
  ASSERT_EQ(whole->groups().size(), all.groups().size());
  for (std::size_t g = 0; g < all.groups().size(); ++g)
    EXPECT_EQ(whole->groups()[g].count, all.groups()[g].count);
  for (const Field field : {Field::position, Field::velocity, Field::density})
    EXPECT_EQ(whole_field({*whole, lost}, row(field), alone),
              whole_field({all, lost}, row(field), alone));
}

/// What is called, in the order of calls; "end" of those that came to theirs.
class Listener : public Reduction {
 public:
  void begin(const JointCall& call) override { calls.push_back(call); }
  void end() override { ++ends; }
  std::vector<JointCall> calls;
  int ends = 0;
};

TEST(WholeSoilTest, ALeadingPartSaysWhatItCalls) {
  using Member = JointCall::Member;
  const auto listener = std::make_shared<Listener>();
  RunOptions options{1, {}};
  options.reduction = listener;
  Simulation simulation(small_slope("modern", 10.0, 1.0, 1.0), options);
  simulation.step();
  static_cast<void>(simulation.field("density"));
  static_cast<void>(simulation.ids());
  static_cast<void>(simulation.probe(0));
  static_cast<void>(simulation.energy());
  static_cast<void>(simulation.wall_reactions());
  static_cast<void>(simulation.density_bound_count());
  static_cast<void>(simulation.face_hold_count());
  simulation.require_sound();
  simulation.set_step_factor(0.5);
  const Snapshot snapshot = simulation.snapshot();
  simulation = Simulation(simulation.scene(), snapshot, simulation.options());
  std::vector<Member> members;
  for (const JointCall& call : listener->calls) members.push_back(call.member);
  EXPECT_EQ(members, std::vector<Member>({Member::make, Member::step, Member::field, Member::ids,
                                          Member::probe, Member::energy, Member::wall_reactions,
                                          Member::density_bound_count, Member::face_hold_count,
                                          Member::require_sound, Member::set_step_factor,
                                          Member::snapshot, Member::make}));
  EXPECT_EQ(listener->ends, 13);
  EXPECT_EQ(listener->calls[10].number, 0.5);
  // What cannot be called is nobody's business.
  EXPECT_THROW(static_cast<void>(simulation.field("colour")), std::exception);
  EXPECT_EQ(listener->calls.size(), 13U);
}

}  // namespace
}  // namespace scarp::test
