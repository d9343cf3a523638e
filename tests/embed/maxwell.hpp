// SPDX-License-Identifier: BSD-3-Clause
/// A soil model of its own: an elastic body whose shear stress fades with time (Maxwell).
#pragma once

#include <scarp/custom_model.hpp>

using namespace scarp::kernels;

struct Maxwell {
  double youngs_modulus = required, poisson_ratio = required;
  double relaxation_time = required;  // [s]

  static constexpr std::string_view name = "maxwell";
  static constexpr std::array<ParameterSpec, 3> parameters{
      youngs_modulus_spec, poisson_ratio_spec,
      ParameterSpec{"relaxation_time", Unit::time, 1e-3, 1e9, required, required, nullptr,
                    "time in which shear stress falls to 1/e"}};
  static constexpr auto members(auto& s) {
    return std::tie(s.youngs_modulus, s.poisson_ratio, s.relaxation_time);
  }
  static constexpr std::array<StateField, 1> state_fields{
      {{"faded_stress", "Pa", 0.0, true, true, "sum of sqrt(J2) that has faded"}}};
  static constexpr bool yields = false;

  struct Constants {
    ElasticModuli moduli;
    double rate;  // [1/s]
  };
  Constants prepare(const MaterialSetting&) const {
    return {elastic_moduli(youngs_modulus, poisson_ratio), 1.0 / relaxation_time};
  }
  static constexpr ElasticModuli moduli(const Constants& c) { return c.moduli; }

  template <class T>
  static SymTensor<T> update(const Constants& c, const StrainIncrement<T>& step,
                             SymTensor<T>& stress, History<T, 1>& history) {
    stress = elastic_trial(c.moduli, step, stress);
    const SymTensor<T> fading = T(c.rate * step.time) * deviator(stress);
    stress = stress - fading;
    history.change[0] = root_j2(fading);
    return isotropic(T(0.0));  // no plastic strain
  }
};
