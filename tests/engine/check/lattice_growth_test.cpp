// SPDX-License-Identifier: BSD-3-Clause
/// Growth of zigzags under pressure: the closed form against the engine, and what `scarp check`
/// says.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/check/lattice_growth.hpp"
#include "engine/check/warnings.hpp"
#include "engine/scene/smoothing_choice.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

constexpr double pressure = 100e3, youngs = 10e6;

struct Setting {
  SmoothingFunction smoothing;
  double ratio, alpha;
};

/// Elastic soil between smooth faces on all sides, squeezed, without gravity: an endless lattice.
Scene squeezed(const Setting& setting) {
  Scene scene;
  scene.spacing = 1.0;
  scene.gravity = {0, 0, 0};
  scene.numerics = preset("modern");
  scene.numerics.smoothing = setting.smoothing;
  scene.numerics.smoothing_ratio = setting.ratio;
  scene.numerics.viscosity_alpha = setting.alpha;
  scene.materials = {elastic(youngs)};
  scene.bodies = {{.shape = Box{{0, 0, 0}, {12, 12, 0}}}};
  scene.walls = {wall_of("box", WallKind::free_slip,
                         {facet_2d(0, 0, 12, 0), facet_2d(12, 0, 12, 12), facet_2d(12, 12, 0, 12),
                          facet_2d(0, 12, 0, 0)})};
  scene.initial_stress = InitialStress::uniform;
  scene.uniform_stress = {-pressure, -pressure, -pressure, 0, 0, 0};
  scene.stages = {stage_for("stand", 1e6)};
  return scene;
}

double closed_form(const Setting& setting) {
  const Scene scene = squeezed(setting);
  const auto moduli = scene.materials[0].model.moduli();
  LoadedLattice lattice;
  lattice.smoothing = &smoothing_of(scene);
  lattice.smoothing_ratio = setting.ratio;
  lattice.wave_modulus = moduli.wave_modulus();
  lattice.shear_modulus = moduli.shear_modulus;
  lattice.inertia = 2000.0;
  lattice.viscosity_alpha = setting.alpha;
  lattice.pressure = pressure;
  return growth_rate(lattice);
}

double kinetic(const Simulation& simulation) { return simulation.energy().kinetic; }

/// Half the rate of the kinetic energy between a thousand times and 10^8 times its least: of the
/// fastest wave alone. 0 where it never grows a thousandfold in the time.
double measured(const Setting& setting, double time) {
  Simulation simulation(squeezed(setting), {1, {}});
  simulation.step();
  simulation.perturb(1e-7);
  double least = kinetic(simulation), begun = 0.0, from = 0.0;
  while (simulation.last_step().time < time) {
    simulation.step();
    const double now = kinetic(simulation), at = simulation.last_step().time;
    least = std::min(least, now);
    if (begun == 0.0 && now > 1e3 * least) begun = at, from = now;
    if (now > 1e8 * least) return 0.5 * std::log(now / from) / (at - begun);
  }
  return 0.0;
}

TEST(LatticeGrowthTest, TheClosedFormIsWhatTheEngineDoes) {
  using enum SmoothingFunction;
  // The sum of waves that grow alike lags behind the fastest one, and the box has waves of 12
  // spacings alone: within a tenth.
  for (const Setting& s : {Setting{cubic_spline, 1.3, 0.0}, Setting{cubic_spline, 1.5, 0.0},
                           Setting{cubic_spline, 1.5, 0.1}, Setting{cubic_spline, 2.0, 0.0}}) {
    const double expected = closed_form(s);
    EXPECT_GT(expected, 0.5) << s.ratio;
    EXPECT_NEAR(measured(s, 30.0 / expected), expected, 0.1 * expected) << s.ratio;
  }
  for (const Setting& s : {Setting{cubic_spline, 1.2, 0.0}, Setting{yang_liu, 1.3, 0.0},
                           Setting{wendland_c2, 1.5, 0.0}, Setting{wendland_c2, 2.0, 0.0}}) {
    EXPECT_LT(closed_form(s), 1e-3) << s.ratio;
    EXPECT_EQ(measured(s, 10.0), 0.0) << s.ratio;
  }
}

TEST(LatticeGrowthTest, WhatModernTakesStandsInBothDimensions) {
  for (const int dimension : {2, 3}) {
    LoadedLattice lattice;
    lattice.dimension = dimension;
    lattice.wave_modulus = 13.5e6;  // E = 10 MPa, nu = 0.3
    lattice.shear_modulus = 3.85e6;
    lattice.inertia = 2000.0;
    lattice.pressure = 400e3;  // below 20 m of soil
    lattice.down = dimension == 2 ? Vec3{0, -1, 0} : Vec3{0, 0, -1};
    const auto rate = [&](const Numerics& numerics) {
      lattice.smoothing = &smoothing_of(numerics, dimension);
      lattice.smoothing_ratio = smoothing_ratio_of(numerics, dimension);
      return growth_rate(lattice);
    };
    for (const double k0 : {0.43, 1.0}) {
      lattice.k0 = k0;
      EXPECT_EQ(rate(preset("modern")), 0.0) << dimension;
    }
    // In 3D the cubic spline has no ratio with so few neighbours that stands.
    Numerics cubic = preset("modern");
    cubic.smoothing = SmoothingFunction::cubic_spline;
    for (const double ratio : {1.2, 1.3, 1.4}) {
      cubic.smoothing_ratio = ratio;
      if (dimension == 3 || ratio > 1.2) {
        EXPECT_GT(rate(cubic), 0.1) << ratio;
      }
    }
  }
}

std::string all_warnings(const Scene& scene) {
  std::string all;
  for (const std::string& warning : warnings(scene)) all += warning + "\n";
  return all;
}

TEST(LatticeGrowthTest, CheckNamesTheSettingAndWhatToTry) {
  Scene scene = small_slope("modern", 10.0, 10.0, 1.0);
  scene.stages[0].until = StageEnd::rest;
  const std::string words = "does not stand under the 294 kPa at the base of material 'clay'";
  for (const double ratio : {1.5, 2.0}) {
    scene.numerics.smoothing_ratio = ratio;
    scene.stages[1].duration = ratio == 1.5 ? 10.0 : 30.0;
    const std::string all = all_warnings(scene);
    EXPECT_NE(all.find(words), std::string::npos) << all;
    EXPECT_NE(all.find("Try smoothing = \"wendland_c2\" with the same ratio."), std::string::npos)
        << all;
    Scene tried = scene;
    tried.numerics.smoothing = SmoothingFunction::wendland_c2;
    EXPECT_EQ(all_warnings(tried).find("zigzag"), std::string::npos);
  }
  scene.numerics.smoothing_ratio = 1.2;
  EXPECT_EQ(all_warnings(scene).find("zigzag"), std::string::npos);
  // Nothing has the time to grow.
  scene.numerics.smoothing_ratio = 1.5;
  scene.stages[1].duration = 1.0;
  EXPECT_EQ(all_warnings(scene).find("zigzag"), std::string::npos);
}

}  // namespace
}  // namespace scarp::test
