// SPDX-License-Identifier: BSD-3-Clause
/// What other codes have been caught at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "engine/check/warnings.hpp"
#include "engine/output/results.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

/// Bed between smooth sides on a rough base.
Scene bed(const std::string& preset_name, Material material) {
  Scene scene = elastic_column(preset_name, 2.0, 0.1);
  scene.materials = {std::move(material)};
  scene.walls = {
      wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 1, 0)}),
      wall_of("sides", WallKind::free_slip, {facet_2d(1, 0, 1, 4), facet_2d(0, 4, 0, 0)})};
  scene.initial_stress = InitialStress::geostatic;
  Stage settle = stage_for("settle", 0.5);
  settle.damping = 60.0;
  settle.reset_after = true;
  scene.stages = {settle, stage_for("rest", 1.0)};
  return scene;
}

TEST(PeersTest, ACohesiveBedAtRestKeepsItsWeight) {  // Chrono, pull request 767
  for (const char* name : {"paper", "modern"}) {
    Simulation simulation(bed(name, clay()), {1, {}});
    while (!simulation.finished()) simulation.step();
    const auto position = simulation.field("position"), stress = simulation.field("stress");
    const double at_base = 2000.0 * 9.81 * 2.0;
    // `paper` sees 1/M of it, M = 0.9452 (THEORY.md section 2); the rest is the band of the case
    // `rest`, 2 %.
    const double share =
        simulation.scene().numerics.lattice_normalisation ? 1.0 : 1.0 / simulation.lattice_moment();
    for (std::size_t k = 0; k < position.size() / 3; ++k) {
      const double weight = -2000.0 * 9.81 * (2.0 - position[3 * k + 1]);
      EXPECT_NEAR(stress[6 * k + 1], share * weight, 0.02 * at_base) << name;
    }
  }
}

TEST(PeersTest, ARoughBaseFeedsNoWaves) {  // once grew from round-off to 6 cm/s at 0.2 per second
  Scene scene;
  scene.spacing = 0.5;
  scene.numerics = preset("modern");
  scene.materials = {clay()};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {5, 4, 0}}}};
  scene.walls = {
      wall_of("base", WallKind::no_slip, {facet_2d(0, 0, 5, 0)}),
      wall_of("sides", WallKind::free_slip, {facet_2d(5, 0, 5, 9), facet_2d(0, 9, 0, 0)})};
  scene.initial_stress = InitialStress::geostatic;
  scene.stages = {stage_for("rest", 100.0)};
  Simulation simulation(scene, {1, {}});
  simulation.step();
  simulation.perturb(1e-6);
  const auto fastest_until = [&](double from, double until) {
    double fastest = 0.0;
    while (simulation.last_step().time < until) {
      simulation.step();
      if (simulation.last_step().time > from)
        fastest = std::max(fastest, simulation.last_step().max_velocity);
    }
    return fastest;
  };
  // Longer than the beat of the two modes that grew, 4 s.
  const double before = fastest_until(20.0, 26.0), after = fastest_until(40.0, 46.0);
  EXPECT_LT(after, before);
}

TEST(PeersTest, WithoutFrictionNothingIsNaN) {  // Kratos, issue 14608
  for (const double cohesion : {0.0, 10e3}) {
    Scene scene = small_slope("modern", 0.1, 1.0, 3.0);
    scene.materials[0].model.set("cohesion", cohesion);
    scene.materials[0].model.set("friction_angle", 0.0);
    scene.materials[0].model.set("dilation_angle", 0.0);
    Simulation simulation(scene, {1, {}});
    while (!simulation.finished()) simulation.step();
    for (const FieldInfo& info : simulation.fields()) {
      for (const double value : simulation.field(info.name)) ASSERT_TRUE(std::isfinite(value));
    }
    // sqrt(J2) <= k_c = c/SRF in plane strain with phi = 0; round-off of 300 kPa beside it.
    const auto s = simulation.field("stress");
    for (std::size_t k = 0; k < s.size(); k += 6) {
      const double p = (s[k] + s[k + 1] + s[k + 2]) / 3.0;
      const double j2 =
          0.5 * (std::pow(s[k] - p, 2) + std::pow(s[k + 1] - p, 2) + std::pow(s[k + 2] - p, 2)) +
          s[k + 3] * s[k + 3];
      EXPECT_LE(std::sqrt(j2), cohesion / 3.0 + 1e-8 * 300e3);
    }
  }
}

TEST(PeersTest, NoGrainLeavesThroughWalls) {  // cb-geo/mpm, issue 80
  for (const char* name : {"paper", "modern"}) {
    for (const WallKind kind : {WallKind::no_slip, WallKind::free_slip}) {
      Scene scene =
          bed(name, {"sand", DruckerPrager{5e6, 0.3, 0.0, 0.5, 0.0, Cone::plane_strain}, 1600.0});
      scene.walls = {
          wall_of("box", kind, {facet_2d(0, 0, 3, 0), facet_2d(3, 0, 3, 6), facet_2d(0, 6, 0, 0)})};
      scene.initial_stress = InitialStress::zero;
      scene.bodies[0].velocity = {6.0, -3.0, 0.0};
      scene.bodies[0].shape = Box{{1, 0.5, 0}, {2, 2.5, 0}};
      scene.stages = {stage_for("thrown", 2.0)};
      Simulation simulation(scene, {1, {}});
      while (!simulation.finished()) simulation.step();
      const auto position = simulation.field("position");
      for (std::size_t k = 0; k < position.size(); k += 3) {
        // Half a spacing behind a face a grain counts as lost.
        EXPECT_GT(position[k], -0.05) << name;
        EXPECT_LT(position[k], 3.05) << name;
        EXPECT_GT(position[k + 1], -0.05) << name;
      }
    }
  }
}

TEST(PeersTest, DilationIsReported) {
  Scene scene = small_slope("modern", 0.1, 2.0, 2.5);
  scene.materials[0].model.set("dilation_angle", 0.17);
  Simulation simulation(scene, {1, {}});
  while (!simulation.finished()) simulation.step();
  const auto measures = basic_measures(simulation);
  const auto least = std::find_if(measures.begin(), measures.end(), [](const Measure& m) {
    return m.name == "least density over reference density";
  });
  ASSERT_NE(least, measures.end());
  EXPECT_LT(least->value, 0.99);
}

TEST(PeersTest, NoOptionOfTheNumericsSilentlyDoesNothing) {
  using Change = std::function<void(Numerics&)>;
  struct Option {
    std::string name;
    Change where, change;  ///< on what it acts, and what it changes
  };
  const Change plain = [](Numerics&) {};
  const Change verlet = [](Numerics& n) {
    n.integrator = Integrator::verlet;
    n.cfl = 0.2;
  };
  const Change tense = [](Numerics& n) { n.artificial_stress = 0.3; };
  const std::vector<Option> options{
      {"smoothing", plain, [](Numerics& n) { n.smoothing = SmoothingFunction::wendland_c2; }},
      {"smoothing_ratio", plain, [](Numerics& n) { n.smoothing_ratio = 1.3; }},
      {"lattice_normalisation", plain, [](Numerics& n) { n.lattice_normalisation = false; }},
      {"gradient_correction", plain, [](Numerics& n) { n.gradient_correction = false; }},
      {"stress_rotation", plain, [](Numerics& n) { n.stress_rotation = StressRotation::jaumann; }},
      {"viscosity_alpha", plain, [](Numerics& n) { n.viscosity_alpha = 0.2; }},
      {"viscosity_beta", plain, [](Numerics& n) { n.viscosity_beta = 2.0; }},
      {"artificial_stress", plain, tense},
      {"artificial_stress_exponent", tense,
       [](Numerics& n) { n.artificial_stress_exponent = 2.55; }},
      {"stress_diffusion", plain, [](Numerics& n) { n.stress_diffusion = 0.0; }},
      {"diffusion_shear_gate", plain, [](Numerics& n) { n.diffusion_shear_gate = 1.0; }},
      {"integrator", [](Numerics& n) { n.cfl = 0.2; }, verlet},
      {"verlet_restart_interval", verlet, [](Numerics& n) { n.verlet_restart_interval = 7; }},
      {"cfl", plain, [](Numerics& n) { n.cfl = 0.7; }},
      {"density_minimum", plain, [](Numerics& n) { n.density_minimum = 0.9999; }},
      {"density_maximum", plain, [](Numerics& n) { n.density_maximum = 1.0; }},
      {"precision", plain, [](Numerics& n) { n.precision = Precision::mixed; }},
  };
  for (const Option& option : options) {
    Scene scene = small_slope("modern", 0.05, 10.0, 2.0);
    option.where(scene.numerics);
    const auto before = run_steps(scene, 150, {1, {}}).field("position");
    option.change(scene.numerics);
    EXPECT_NE(run_steps(scene, 150, {1, {}}).field("position"), before) << option.name;
  }
}

}  // namespace
}  // namespace scarp::test
