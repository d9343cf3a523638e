// SPDX-License-Identifier: BSD-3-Clause
/// Non-associated, perfectly plastic Drucker-Prager model.
#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "kernels/constitutive/linear_elastic.hpp"
#include "kernels/constitutive/model.hpp"

namespace scarp::kernels {

/// How the cone is matched to Coulomb's c and phi.
enum class Cone { plane_strain, outer, inner };

/// Constants of Eqs. 9 and 10: f = sqrt(J2) + alpha_phi I1 - k_c, g = sqrt(J2) + alpha_psi I1.
struct ConeConstants {
  double alpha_phi;
  double k_c;  ///< [Pa]
  double alpha_psi;
};

/// Equation: E11 (plane strain), E12 (outer: 3 - sin phi; inner: 3 + sin phi).
inline ConeConstants cone_constants(const CoulombStrength& strength, Cone match) {
  const double c = strength.cohesion, phi = strength.friction_angle, psi = strength.dilation_angle;
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

/// f = sqrt(J2) + alpha_phi I1 - k_c. Equation: E9.
template <class T>
SCARP_INLINE T yield_function(const ConeConstants& c, const T& root_j2, const T& i1) {
  return root_j2 + T(c.alpha_phi) * i1 - T(c.k_c);
}

/// Puts a trial stress back on the yield surface along the plastic potential, cone or apex, in
/// closed form, and returns the increment of the equivalent deviatoric plastic strain sqrt(2/3 de_p
/// : de_p). Equation: P1; dlambda = f/(G + 9 K alpha_phi alpha_psi), sqrt(J2) -= G dlambda, I1 -= 9
/// K alpha_psi dlambda; if sqrt(J2) would turn negative: I1 = k_c/alpha_phi, s = 0. Limits: exact
/// for one step of any size.
template <class T>
SCARP_INLINE T return_to_cone(const ElasticModuli& moduli, const ConeConstants& c,
                              SymTensor<T>& stress) {
  const double k = moduli.bulk_modulus, g = moduli.shear_modulus;
  const T zero(0.0), one(1.0);
  const T i1 = trace(stress);
  SymTensor<T> s = deviator(stress);
  const T j = root_j2(s);
  const T f = yield_function(c, j, i1);
  const auto yields = f > zero;
  if (none_of(yields)) return zero;
  const T multiplier = f * T(1.0 / (g + 9.0 * k * c.alpha_phi * c.alpha_psi));
  const T j_returned = j - T(g) * multiplier;
  const auto to_cone = j_returned >= zero;
  // Without friction there is no apex: j_returned = k_c, which without cohesion too is 0 but for
  // its sign.
  const T apex = c.alpha_phi > 0.0 ? T(c.k_c / c.alpha_phi) : i1;
  const T i1_new = choose(to_cone, i1 - T(9.0 * k * c.alpha_psi) * multiplier, apex);
  // j = 0 cannot reach the cone except at the apex, where s = 0 anyway.
  const T shrink = choose(to_cone, j_returned / larger(j, T(1e-300)), zero);
  const T scale = choose(yields, shrink, one);
  const T mean = choose(yields, i1_new, i1) * T(1.0 / 3.0);
  stress = {scale * s.xx + mean, scale * s.yy + mean, scale * s.zz + mean,
            scale * s.xy,        scale * s.yz,        scale * s.zx};
  const T increment = choose(to_cone, multiplier, j * T(1.0 / g)) * T(0.57735026918962576);
  return choose(yields, increment, zero);
}

struct DruckerPrager {
  double youngs_modulus = required;  ///< E [Pa]
  double poisson_ratio = required;   ///< nu [-]
  double cohesion = required;        ///< Coulomb's c [Pa]
  double friction_angle = required;  ///< Coulomb's phi [rad]
  double dilation_angle = 0.0;       ///< psi, at most phi [rad]
  Cone cone = Cone::plane_strain;    ///< a scene file in 3D takes `outer` where it says nothing

  static constexpr std::string_view name = "drucker_prager";
  static constexpr std::array<ParameterSpec, 6> parameters{{
      youngs_modulus_spec,
      poisson_ratio_spec,
      {"cohesion", Unit::pressure, 0.0, 1e12, required, required, nullptr, "Coulomb's cohesion c"},
      {"friction_angle", Unit::angle, 0.0, right_angle * 8.0 / 9.0, required, required, nullptr,
       "Coulomb's friction angle phi"},
      {"dilation_angle", Unit::angle, 0.0, right_angle * 8.0 / 9.0, 0.0, 0.0, nullptr,
       "dilation angle psi, at most phi"},
      {"cone", Unit::choice, 0.0, 2.0, 0.0, 1.0, "plane_strain|outer|inner",
       "match of the cone to Coulomb's surface"},
  }};
  static constexpr auto members(auto& self) {
    return std::tie(self.youngs_modulus, self.poisson_ratio, self.cohesion, self.friction_angle,
                    self.dilation_angle, self.cone);
  }
  static constexpr std::array<StateField, 1> state_fields{accumulated_plastic_strain};
  static constexpr bool yields = true;

  struct Constants {
    ElasticModuli elastic;
    ConeConstants cone;
  };
  Constants prepare(const MaterialSetting& setting) const {
    return {elastic_moduli(youngs_modulus, poisson_ratio),
            cone_constants(strength().reduced(setting.strength_reduction), cone)};
  }
  static constexpr ElasticModuli moduli(const Constants& c) { return c.elastic; }

  /// Elastic step, then the return to the cone. Equation: E18, E21, P1. Returns the plastic strain.
  template <class T>
  static SCARP_INLINE SymTensor<T> update(const Constants& c, const StrainIncrement<T>& step,
                                          SymTensor<T>& stress, History<T, 1>& history) {
    stress = elastic_trial(c.elastic, step, stress);
    const SymTensor<T> trial = stress;
    history.change[0] = return_to_cone(c.elastic, c.cone, stress);
    return elastic_strain(c.elastic, trial - stress);
  }

  CoulombStrength strength() const { return {cohesion, friction_angle, dilation_angle}; }
  static double yield_function(const Constants& c, const SymTensor<double>& stress,
                               std::span<const double>) {
    return kernels::yield_function(c.cone, root_j2(deviator(stress)), trace(stress));
  }
  static constexpr std::array<ShownConstant, 3> shown{
      {{"alpha_phi", "-"}, {"k_c", "Pa"}, {"alpha_psi", "-"}}};
  static std::array<double, 3> show(const Constants& c) {
    return {c.cone.alpha_phi, c.cone.k_c, c.cone.alpha_psi};
  }
  std::optional<ParameterComplaint> complaint() const { return dilation_complaint(strength(), 4); }
  std::optional<ParameterComplaint> doubt(int dimension) const {
    if (dimension == 3 || cone != Cone::outer) return {};
    if (!(3.0 * cone_constants(strength(), cone).alpha_phi >= 1.0)) return {};
    return ParameterComplaint{5,
                              "the outer cone of such a friction angle never yields in plane "
                              "strain. Try cone = \"plane_strain\", or less than 42.2 deg."};
  }
};

}  // namespace scarp::kernels
