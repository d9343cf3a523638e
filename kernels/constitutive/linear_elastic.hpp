// SPDX-License-Identifier: BSD-3-Clause
/// Isotropic linear (hypo-)elasticity.
#pragma once

#include <array>
#include <string_view>

#include "kernels/constitutive/parameter_spec.hpp"

namespace scarp::kernels {

/// Elastic moduli of a material, prepared once per run. Equation: E14.
struct ElasticModuli {
  double bulk_modulus;   ///< K [Pa]
  double shear_modulus;  ///< G [Pa]

  /// K + 4/3 G, stress over strain of a plane wave [Pa].
  constexpr double wave_modulus() const { return bulk_modulus + 4.0 / 3.0 * shear_modulus; }
};

/// Equation: E14; K = E/(3(1-2 nu)), G = E/(2(1+nu)). Pre: 0 <= nu < 0.5.
constexpr ElasticModuli elastic_moduli(double youngs_modulus, double poisson_ratio) {
  return {youngs_modulus / (3.0 * (1.0 - 2.0 * poisson_ratio)),
          youngs_modulus / (2.0 * (1.0 + poisson_ratio))};
}

struct LinearElastic {
  static constexpr std::string_view name = "linear_elastic";
  static constexpr std::array<ParameterSpec, 2> parameters{{
      {"youngs_modulus", Unit::pressure, 1e-6, 1e15, required, required, nullptr,
       "Young's modulus E"},
      {"poisson_ratio", Unit::none, 0.0, 0.4999, required, required, nullptr, "Poisson's ratio nu"},
  }};
};

}  // namespace scarp::kernels
