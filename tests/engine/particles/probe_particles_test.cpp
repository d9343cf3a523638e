// SPDX-License-Identifier: BSD-3-Clause
/// The particle of a probe: mirrored scenes, round-off, order, and points far from all soil.
#include "engine/particles/probe_particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/errors.hpp"
#include "engine/particles/probe_reading.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp {
namespace {

constexpr double width = 45.0;

Probe at(double x, double y) { return {"p", {x, y, 0.0}}; }

Vec3 mirrored(const Vec3& point) { return {width - point[0], point[1], point[2]}; }

Scene mirrored(Scene scene) {
  for (auto& point : std::get<Polygon>(scene.bodies[0].shape).points) point[0] = width - point[0];
  return scene;
}

/// Points of the slope where two or four particles tie: crest, toe, one inside the soil, one on its
/// level top.
const std::vector<Probe> ties{at(12, 15), at(32, 5), at(20, 4), at(7, 15)};

TEST(ProbeParticlesTest, AMirroredSceneFollowsTheMirroredParticle) {
  const Scene scene = test::small_slope("modern", 0.1, 0.1, 1.0), image = mirrored(scene);
  const Particles soil = generate_soil(scene), image_soil = generate_soil(image);
  for (const Probe& probe : ties) {
    const ChosenParticle here = particle_of_probe(scene, soil, probe);
    const Vec3 wanted = mirrored(probe.at);
    const ChosenParticle there = particle_of_probe(image, image_soil, at(wanted[0], wanted[1]));
    EXPECT_GT(here.tied, 1u) << probe.at[0];
    EXPECT_EQ(here.tied, there.tied);
    for (std::size_t a = 0; a < 3; ++a) {
      // The lattice is the same to round-off of coordinates below 64 m.
      EXPECT_NEAR(mirrored(image_soil.position[there.id])[a], soil.position[here.id][a], 1e-13)
          << probe.at[0];
    }
  }
}

TEST(ProbeParticlesTest, OfParticlesThatTieTheHighestIsTakenThenTheOneWithMostSoilAround) {
  const Scene scene = test::small_slope("modern", 0.1, 0.1, 1.0);
  const Particles soil = generate_soil(scene);
  const auto place = [&](double x, double y) {
    return soil.position[particle_of_probe(scene, soil, at(x, y)).id];
  };
  EXPECT_EQ(place(12, 15), (Vec3{11.5, 14.5, 0}));  // not the one at the sloping face
  EXPECT_EQ(place(32, 5), (Vec3{31.5, 4.5, 0}));    // not the one with less soil above
  EXPECT_EQ(place(20, 4), (Vec3{19.5, 4.5, 0}));    // of four a high one, toward the centre of all
}

TEST(ProbeParticlesTest, RoundOffAndOrderDoNotTurnATie) {
  const Scene scene = test::small_slope("modern", 0.1, 0.1, 1.0);
  const Particles soil = generate_soil(scene);
  Particles shaken = soil;
  std::reverse(shaken.position.begin(), shaken.position.end());
  for (std::size_t k = 0; k < shaken.position.size(); ++k) {
    for (std::size_t a = 0; a < 2; ++a) {
      const double sign = std::sin(12.9898 * static_cast<double>(2 * k + a)) > 0.0 ? 1.0 : -1.0;
      shaken.position[k][a] += sign * 1e-9 * scene.spacing;
    }
  }
  for (const Probe& probe : ties) {
    const std::size_t plain = particle_of_probe(scene, soil, probe).id;
    const std::size_t other = particle_of_probe(scene, shaken, probe).id;
    EXPECT_EQ(soil.position.size() - 1 - other, plain) << probe.at[0];
  }
}

TEST(ProbeParticlesTest, APointFurtherThanTwoSpacingsFromAllSoilIsAnError) {
  Scene scene = test::small_slope("modern", 0.1, 0.1, 1.0);
  const Particles soil = generate_soil(scene);
  // The highest particles are at y = 14.5.
  EXPECT_DOUBLE_EQ(particle_of_probe(scene, soil, at(5.5, 16.5)).distance, 2.0);
  scene.probes = {at(5.5, 16.6)};
  scene.probes[0].line = 7;
  scene.file = "slope.toml";
  try {
    particle_of_probe(scene, soil, scene.probes[0]);
    FAIL() << "no error";
  } catch (const SceneError& error) {
    const std::string message = error.what();
    EXPECT_EQ(message.find("slope.toml:7: key 'probe[0]' = 'p' at (5.5, 16.6): "), 0u) << message;
    EXPECT_NE(message.find("2.1 m away"), std::string::npos) << message;
  }
}

TEST(ProbeParticlesTest, TheSimulationTellsWhatItFollows) {
  const Simulation simulation(test::small_slope("modern", 0.1, 0.1, 1.0));
  ASSERT_EQ(simulation.probe_particles().size(), 1u);
  const ProbeParticle& crest = simulation.probe_particles()[0];
  EXPECT_EQ(crest.probe, "crest");
  EXPECT_EQ(crest.tied, 2u);
  EXPECT_DOUBLE_EQ(crest.distance, std::sqrt(0.5));
  EXPECT_EQ(crest.start, simulation.probe("crest").position);
  EXPECT_EQ(crest.start, simulation.probe(0).position);
  EXPECT_THROW(static_cast<void>(simulation.probe("toe")), Error);
}

/// A part of a soil may have given the particle of a probe away.
TEST(ProbeReadingTest, AParticleThatIsNotHereIsNamed) {
  const Scene scene = test::elastic_column("modern", 1.0, 0.1);
  constexpr Field used[]{Field::position, Field::velocity, Field::density, Field::stress};
  ParticleBuffers particles(2, {{{.mass = 1.0}, 0, 3, padded(3)}}, used);
  for (std::int64_t k = 0; k < 3; ++k) {
    particles.ids()[static_cast<std::size_t>(k)] = 10 + k;
    particles.component(Field::position, 1)[k] = 0.5 * static_cast<double>(k);
  }
  const ProbeParticle crest{.probe = "crest", .particle = 12};
  EXPECT_EQ(read_probe(scene, particles, crest).position[1], 1.0);
  const std::int64_t given_away = 2;
  particles.remove({&given_away, 1});
  try {
    read_probe(scene, particles, crest);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what())
                  .find("probe 'crest': it follows particle 12, which is not "
                        "among the 2 particles"),
              std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace scarp
