// SPDX-License-Identifier: BSD-3-Clause
/// Isotropic linear (hypo-)elasticity.
#pragma once

#include <string_view>

#include "kernels/constitutive/model.hpp"

namespace scarp::kernels {

inline constexpr ParameterSpec youngs_modulus_spec{
    "youngs_modulus", Unit::pressure, 1e-6, 1e15, required, required, nullptr, "Young's modulus E"};
inline constexpr ParameterSpec poisson_ratio_spec{
    "poisson_ratio", Unit::none, 0.0, 0.4999, required, required, nullptr, "Poisson's ratio nu"};

struct LinearElastic {
  double youngs_modulus = required;  ///< E [Pa]
  double poisson_ratio = required;   ///< nu [-]

  static constexpr std::string_view name = "linear_elastic";
  static constexpr std::array<ParameterSpec, 2> parameters{youngs_modulus_spec, poisson_ratio_spec};
  static constexpr auto members(auto& self) {
    return std::tie(self.youngs_modulus, self.poisson_ratio);
  }
  static constexpr std::array<StateField, 0> state_fields{};
  static constexpr bool yields = false;

  using Constants = ElasticModuli;
  Constants prepare(const MaterialSetting&) const {
    return elastic_moduli(youngs_modulus, poisson_ratio);
  }
  static constexpr ElasticModuli moduli(const Constants& c) { return c; }

  /// Equation: E18 without its plastic part. Returns the plastic strain: none.
  template <class T>
  static SCARP_INLINE SymTensor<T> update(const Constants& c, const StrainIncrement<T>& step,
                                          SymTensor<T>& stress, History<T, 0>&) {
    stress = elastic_trial(c, step, stress);
    return isotropic(T(0.0));
  }
};

}  // namespace scarp::kernels
