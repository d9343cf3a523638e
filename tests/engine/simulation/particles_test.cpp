// SPDX-License-Identifier: BSD-3-Clause
/// Soil that a program supplies as particles, with ids of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

#include "engine/errors.hpp"
#include "engine/particles/generate.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// A slope that slides, with a probe, and the particles that its body is filled with.
struct Slope {
  Scene drawn = small_slope("modern", 0.02, 10.0, 1.8);
  Scene bare;
  Particles particles;

  Slope() {
    drawn.initial_stress = InitialStress::uniform;
    drawn.uniform_stress = {-1e3, -2e3, -1e3, 0.0, 0.0, 0.0};
    particles = generate_soil(drawn);
    Probe probe;
    probe.name = "middle";
    probe.at = particles.position[particles.position.size() / 2];
    drawn.probes = {probe};
    bare = drawn;
    bare.bodies.clear();
  }
};

void step(Simulation& simulation, int steps) {
  for (int k = 0; k < steps; ++k) simulation.step();
}

void expect_same(const Simulation& a, const Simulation& b) {
  EXPECT_EQ(a.last_step().time, b.last_step().time);
  EXPECT_EQ(a.field("position"), b.field("position"));
  EXPECT_EQ(a.field("stress"), b.field("stress"));
  EXPECT_EQ(a.probe(0).position, b.probe(0).position);
}

TEST(SuppliedParticlesTest, MoveAsTheBodyTheyComeFrom) {
  const Slope slope;
  Simulation drawn(slope.drawn, {1, {}}), supplied(slope.bare, slope.particles, {1, {}});
  step(drawn, 60);
  step(supplied, 60);
  expect_same(drawn, supplied);
}

TEST(SuppliedParticlesTest, BringStressAndDensity) {
  Slope slope;
  const std::size_t count = slope.particles.position.size();
  slope.bare.initial_stress = InitialStress::geostatic;  // what is supplied goes before
  for (std::size_t k = 0; k < count; ++k) {
    const auto number = static_cast<double>(k);
    slope.particles.stress.push_back({-number, -2.0 * number, -3.0 * number, 1.0, 0.0, 0.0});
    slope.particles.density.push_back(1900.0 + number);
  }
  const Simulation simulation(slope.bare, slope.particles, {1, {}});
  const std::vector<double> stress = simulation.field("stress"),
                            density = simulation.field("density");
  for (std::size_t k = 0; k < count; ++k) {
    ASSERT_EQ(stress[6 * k + 1], slope.particles.stress[k][1]);
    ASSERT_EQ(density[k], slope.particles.density[k]);
  }
}

TEST(SparseIdsTest, NameParticlesAndChangeNothingElse) {
  Slope slope;
  Particles named = slope.particles;
  const std::size_t count = named.position.size();
  for (std::size_t k = 0; k < count; ++k)
    named.id.push_back(1'000'000'000'000 + 7 * static_cast<std::int64_t>(k));
  Simulation dense(slope.bare, slope.particles, {1, {}}), sparse(slope.bare, named, {1, {}});
  step(dense, 60);
  step(sparse, 60);
  expect_same(dense, sparse);
  EXPECT_EQ(sparse.ids(), named.id);
  const std::vector<double> ids = sparse.field("id");
  ASSERT_EQ(ids.size(), count);
  for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(ids[k], static_cast<double>(named.id[k]));
  EXPECT_EQ(sparse.probe_particles()[0].particle,
            1'000'000'000'000 + 7 * dense.probe_particles()[0].particle);

  // Noise goes by the ids, and every particle has its own.
  std::vector<double> before = sparse.field("velocity");
  sparse.perturb(1.0);
  std::vector<double> after = sparse.field("velocity"), noise;
  for (std::size_t k = 0; k < count; ++k) noise.push_back(after[3 * k] - before[3 * k]);
  std::sort(noise.begin(), noise.end());
  EXPECT_EQ(std::adjacent_find(noise.begin(), noise.end()), noise.end());
}

TEST(SparseIdsTest, GoOnFromASnapshot) {
  Slope slope;
  for (std::size_t k = slope.particles.position.size(); k > 0; --k)
    slope.particles.id.push_back(11 * static_cast<std::int64_t>(k) + 5);  // descending
  Simulation first(slope.bare, slope.particles, {1, {}});
  step(first, 40);
  Simulation second(slope.bare, slope.particles, first.snapshot(), {1, {}});
  step(first, 40);
  step(second, 40);
  expect_same(first, second);
  EXPECT_EQ(first.ids(), second.ids());
  // Particles of other names are another run's.
  slope.particles.id[3] += 1;
  EXPECT_THROW(Simulation(slope.bare, slope.particles, first.snapshot(), {1, {}}), CheckpointError);
}

TEST(SuppliedParticlesTest, AreRefusedWithWhatIsWrong) {
  const Slope slope;
  const auto complaint = [&](const std::function<void(Particles&, Scene&)>& spoil) {
    Particles particles = slope.particles;
    Scene scene = slope.bare;
    spoil(particles, scene);
    try {
      const Simulation simulation(scene, particles, {1, {}});
    } catch (const SceneError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  const auto expect = [&](const char* words, const std::function<void(Particles&, Scene&)>& spoil) {
    EXPECT_NE(complaint(spoil).find(words), std::string::npos) << complaint(spoil);
  };
  EXPECT_EQ(complaint([](Particles&, Scene&) {}), "nothing");
  expect("there are none", [](Particles& p, Scene&) { p = {}; });
  expect("'velocity' has 1 entries", [](Particles& p, Scene&) { p.velocity.resize(1); });
  expect("'stress' has 1 entries", [](Particles& p, Scene&) { p.stress.resize(1); });
  expect("'position' of number 2 is", [](Particles& p, Scene&) { p.position[2][1] = NAN; });
  expect("'material' of number 4 is 9", [](Particles& p, Scene&) { p.material[4] = 9; });
  expect("comes twice", [](Particles& p, Scene&) { p.id.assign(p.position.size(), 3); });
  expect("an 'id' is -3", [](Particles& p, Scene&) {
    for (std::size_t k = 0; k < p.position.size(); ++k)
      p.id.push_back(static_cast<std::int64_t>(k) - 3);
  });
  expect("'density' of number 0 is 0",
         [](Particles& p, Scene&) { p.density.assign(p.position.size(), 0.0); });
  expect("what weight lies above",
         [](Particles&, Scene& s) { s.initial_stress = InitialStress::geostatic; });
}

}  // namespace
}  // namespace scarp::test
