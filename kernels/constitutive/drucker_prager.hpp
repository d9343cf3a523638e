// SPDX-License-Identifier: BSD-3-Clause
/// Non-associated, perfectly plastic Drucker-Prager model: parameters, cone constants, yield
/// function.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <string_view>

#include "kernels/constitutive/linear_elastic.hpp"
#include "kernels/constitutive/parameter_spec.hpp"

namespace scarp::kernels {

/// How the cone is matched to Coulomb's c and phi.
enum class Cone { plane_strain, outer, inner };

/// Constants of Eqs. 9 and 10: f = sqrt(J2) + alpha_phi I1 - k_c, g = sqrt(J2) + alpha_psi I1.
struct ConeConstants {
  double alpha_phi;
  double k_c;  ///< [Pa]
  double alpha_psi;
};

struct DruckerPrager {
  static constexpr std::string_view name = "drucker_prager";
  enum Index { youngs_modulus, poisson_ratio, cohesion, friction_angle, dilation_angle, cone };
  static constexpr double right_angle = 1.5707963267948966;
  static constexpr std::array<ParameterSpec, 6> parameters{{
      LinearElastic::parameters[0],
      LinearElastic::parameters[1],
      {"cohesion", Unit::pressure, 0.0, 1e12, required, required, nullptr, "Coulomb's cohesion c"},
      {"friction_angle", Unit::angle, 0.0, right_angle * 8.0 / 9.0, required, required, nullptr,
       "Coulomb's friction angle phi"},
      {"dilation_angle", Unit::angle, 0.0, right_angle * 8.0 / 9.0, 0.0, 0.0, nullptr,
       "dilation angle psi, at most phi"},
      {"cone", Unit::choice, 0.0, 2.0, 0.0, 1.0, "plane_strain|outer|inner",
       "match of the cone to Coulomb's surface"},
  }};

  /// Equation: E11 (plane strain), E12 (outer: 3 - sin phi; inner: 3 + sin phi).
  static ConeConstants cone_constants(double c, double phi, double psi, Cone match) {
    if (match == Cone::plane_strain) {
      const auto root = [](double t) { return std::sqrt(9.0 + 12.0 * t * t); };
      const double t = std::tan(phi), p = std::tan(psi);
      return {t / root(t), 3.0 * c / root(t), p / root(p)};
    }
    const double sign = match == Cone::outer ? -1.0 : 1.0;
    const auto below = [sign](double angle) {
      return std::sqrt(3.0) * (3.0 + sign * std::sin(angle));
    };
    return {2.0 * std::sin(phi) / below(phi), 6.0 * c * std::cos(phi) / below(phi),
            2.0 * std::sin(psi) / below(psi)};
  }

  /// Equation: E31; c/SRF and atan(tan phi / SRF); the dilation angle is kept but never above phi.
  static ConeConstants reduced(std::span<const double> p, double reduction) {
    const double phi = std::atan(std::tan(p[friction_angle]) / reduction);
    return cone_constants(p[cohesion] / reduction, phi, std::fmin(p[dilation_angle], phi),
                          static_cast<Cone>(static_cast<int>(p[cone])));
  }
};

}  // namespace scarp::kernels
