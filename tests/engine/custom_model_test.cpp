// SPDX-License-Identifier: BSD-3-Clause
/// A soil model outside the library's list, with history variables of its own.
#include "engine/custom_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/checkpoint/snapshot.hpp"
#include "engine/errors.hpp"
#include "engine/simulation.hpp"
#include "tests/support/small_scenes.hpp"

namespace scarp::test {
namespace {

using kernels::History;
using kernels::SymTensor;

/// Drucker-Prager by another name, which counts its volumetric strain too.
struct CountingSoil {
  double youngs_modulus = 10e6, poisson_ratio = 0.3, cohesion = 5e3, friction_angle = 0.35;

  static constexpr std::string_view name = "counting_soil";
  static constexpr std::array<kernels::ParameterSpec, 4> parameters{
      kernels::youngs_modulus_spec, kernels::poisson_ratio_spec, kernels::cohesion_spec,
      kernels::friction_angle_spec};
  static constexpr auto members(auto& self) {
    return std::tie(self.youngs_modulus, self.poisson_ratio, self.cohesion, self.friction_angle);
  }
  static constexpr std::array<kernels::StateField, 2> state_fields{
      {kernels::accumulated_plastic_strain,
       {"volumetric_strain", "-", 0.25, false, true, "sum of volumetric strain, from a quarter"}}};
  static constexpr bool yields = true;

  struct Constants {
    kernels::ElasticModuli elastic;
    kernels::ConeConstants cone;
  };
  Constants prepare(const kernels::MaterialSetting& setting) const {
    const kernels::CoulombStrength strength{cohesion, friction_angle, 0.0};
    return {
        kernels::elastic_moduli(youngs_modulus, poisson_ratio),
        kernels::cone_constants(strength.reduced(setting.strength_reduction), Cone::plane_strain)};
  }
  static constexpr kernels::ElasticModuli moduli(const Constants& c) { return c.elastic; }
  template <class T>
  static SCARP_INLINE SymTensor<T> update(const Constants& c,
                                          const kernels::StrainIncrement<T>& step,
                                          SymTensor<T>& stress, History<T, 2>& history) {
    stress = kernels::elastic_trial(c.elastic, step, stress);
    const SymTensor<T> trial = stress;
    history.change[0] = kernels::return_to_cone(c.elastic, c.cone, stress);
    history.change[1] = trace(step.strain);
    return kernels::elastic_strain(c.elastic, trial - stress);
  }
};

Scene slope_of(const SoilModel& model, const char* preset_name) {
  Scene scene = small_slope(preset_name, 0.05, 10.0, 2.0);
  scene.materials[0].model = model;
  return scene;
}

class CustomModelTest : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Presets, CustomModelTest, testing::Values("paper", "modern"));

TEST_P(CustomModelTest, RunsAsTheModelOfTheListThatItRepeats) {
  const CountingSoil own;
  Simulation custom(slope_of(custom_model(own), GetParam()), {1, {}});
  Simulation listed(slope_of(DruckerPrager{own.youngs_modulus, own.poisson_ratio, own.cohesion,
                                           own.friction_angle},
                             GetParam()),
                    {1, {}});
  for (int k = 0; k < 40; ++k) {
    custom.step();
    listed.step();
  }
  const auto a = custom.field("stress"), b = listed.field("stress");
  ASSERT_EQ(a.size(), b.size());
  // Other instructions round differently; over 40 steps that grows little.
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-6 * 1e4);
  EXPECT_EQ(custom.scene().materials[0].model.name(), "counting_soil");
}

TEST_P(CustomModelTest, HistoryHasItsNamesItsStartAndSurvivesASnapshot) {
  const Scene scene = slope_of(custom_model(CountingSoil{}), GetParam());
  Simulation run(scene, {1, {}});
  for (const double value : run.field("volumetric_strain")) ASSERT_EQ(value, 0.25);
  for (int k = 0; k < 20; ++k) run.step();
  const std::vector<double> strain = run.field("volumetric_strain");
  EXPECT_TRUE(std::any_of(strain.begin(), strain.end(), [](double v) { return v != 0.25; }));
  Simulation again(scene, run.snapshot(), {1, {}});
  EXPECT_EQ(again.field("volumetric_strain"), strain);
  again.step();
  run.step();
  EXPECT_EQ(again.field("volumetric_strain"), run.field("volumetric_strain"));
  EXPECT_EQ(again.field("stress"), run.field("stress"));
}

TEST(CustomModelTest, IsCheckedLikeTheOthers) {
  CountingSoil wrong;
  wrong.poisson_ratio = 0.6;
  EXPECT_THROW(Simulation(slope_of(custom_model(wrong), "modern"), {1, {}}), SceneError);
}

}  // namespace
}  // namespace scarp::test
