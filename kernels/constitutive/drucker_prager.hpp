// SPDX-License-Identifier: BSD-3-Clause
/// Non-associated Drucker-Prager model.
#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "kernels/constitutive/linear_elastic.hpp"
#include "kernels/constitutive/model.hpp"
#include "kernels/constitutive/softening.hpp"

namespace scarp::kernels {

/// How the cone is matched to Coulomb's c and phi.
enum class Cone { plane_strain, outer, inner };

/// Constants of Eqs. 9 and 10, f = sqrt(J2) + alpha_phi I1 - k_c, g = sqrt(J2) + alpha_psi I1: of
/// one number for a material, or of a vector of particles.
template <class C>
struct ConeOf {
  C alpha_phi;
  C k_c;  ///< [Pa]
  C alpha_psi;
};
using ConeConstants = ConeOf<double>;

/// An angle by its functions.
template <class C>
struct AngleOf {
  C tangent, sine, cosine;
};

/// Equation: E11 (plane strain), E12 (outer: 3 - sin phi; inner: 3 + sin phi).
template <class C>
SCARP_INLINE ConeOf<C> cone_of(const C& c, const AngleOf<C>& phi, const AngleOf<C>& psi,
                               Cone match) {
  if (match == Cone::plane_strain) {
    const auto below = [](const C& t) SCARP_LAMBDA { return root(C(9.0) + C(12.0) * t * t); };
    return {phi.tangent / below(phi.tangent), C(3.0) * c / below(phi.tangent),
            psi.tangent / below(psi.tangent)};
  }
  const C sign(match == Cone::outer ? -1.0 : 1.0);
  const auto below = [&sign](const C& sine)
                         SCARP_LAMBDA { return C(1.7320508075688772) * (C(3.0) + sign * sine); };
  return {C(2.0) * phi.sine / below(phi.sine), C(6.0) * c * phi.cosine / below(phi.sine),
          C(2.0) * psi.sine / below(psi.sine)};
}

inline ConeConstants cone_constants(const CoulombStrength& strength, Cone match) {
  const auto angle = [](double a) {
    return AngleOf<double>{std::tan(a), std::sin(a), std::cos(a)};
  };
  return cone_of(strength.cohesion, angle(strength.friction_angle), angle(strength.dilation_angle),
                 match);
}
/// ... of vectors of particles.
template <class T>
SCARP_INLINE ConeOf<T> cone_of(const CoulombTangents<T>& strength, Cone match) {
  const auto angle = [](const T& tangent) SCARP_LAMBDA {
    const T cosine = T(1.0) / root(T(1.0) + tangent * tangent);
    return AngleOf<T>{tangent, tangent * cosine, cosine};
  };
  return cone_of(strength.cohesion, angle(strength.friction), angle(strength.dilation), match);
}

/// f = sqrt(J2) + alpha_phi I1 - k_c. Equation: E9.
template <class C, class T>
SCARP_INLINE T yield_function(const ConeOf<C>& c, const T& root_j2, const T& i1) {
  return root_j2 + T(c.alpha_phi) * i1 - T(c.k_c);
}

/// Puts a trial stress back on the yield surface along the plastic potential, cone or apex, in
/// closed form, and returns the increment of the equivalent deviatoric plastic strain sqrt(2/3 de_p
/// : de_p). Equation: P1; dlambda = f/(G + 9 K alpha_phi alpha_psi), sqrt(J2) -= G dlambda, I1 -= 9
/// K alpha_psi dlambda; if sqrt(J2) would turn negative: I1 = k_c/alpha_phi, s = 0. Limits: exact
/// for one step of any size.
template <class C, class T>
SCARP_INLINE T return_to_cone(const ElasticModuli& moduli, const ConeOf<C>& c,
                              SymTensor<T>& stress) {
  const C k(moduli.bulk_modulus), g(moduli.shear_modulus), nine(9.0);
  const T zero(0.0), one(1.0);
  const T i1 = trace(stress);
  SymTensor<T> s = deviator(stress);
  const T j = root_j2(s);
  const T f = yield_function(c, j, i1);
  const auto yields = f > zero;
  if (none_of(yields)) return zero;
  const T multiplier = f * T(C(1.0) / (g + nine * k * c.alpha_phi * c.alpha_psi));
  const T j_returned = j - T(g) * multiplier;
  const auto to_cone = j_returned >= zero;
  // Without friction there is no apex: j_returned = k_c, which without cohesion too is 0 but for
  // its sign.
  const T apex = choose(c.alpha_phi > C(0.0), T(c.k_c / c.alpha_phi), i1);
  const T i1_new = choose(to_cone, i1 - T(nine * k * c.alpha_psi) * multiplier, apex);
  // j = 0 cannot reach the cone except at the apex, where s = 0 anyway.
  const T shrink = choose(to_cone, j_returned / larger(j, T(1e-300)), zero);
  const T scale = choose(yields, shrink, one);
  const T mean = choose(yields, i1_new, i1) * T(1.0 / 3.0);
  stress = {scale * s.xx + mean, scale * s.yy + mean, scale * s.zz + mean,
            scale * s.xy,        scale * s.yz,        scale * s.zx};
  const T increment = choose(to_cone, multiplier, j * T(C(1.0) / g)) * T(0.57735026918962576);
  return choose(yields, increment, zero);
}

struct DruckerPrager {
  double youngs_modulus = required;     ///< E [Pa]
  double poisson_ratio = required;      ///< nu [-]
  double cohesion = required;           ///< Coulomb's c [Pa]
  double friction_angle = required;     ///< Coulomb's phi [rad]
  double dilation_angle = 0.0;          ///< psi, at most phi [rad]
  Cone cone = Cone::plane_strain;       ///< a scene file in 3D takes `outer` where it says nothing
  double residual_cohesion = cohesion;  ///< after `softening_slip` [Pa]
  double residual_friction_angle = friction_angle;     ///< [rad]
  SofteningLaw softening = SofteningLaw::exponential;  ///< from peak to residual
  double softening_slip = 0.0;                         ///< [m]
  double dilation_limit = 1.0;                         ///< volumetric strain where psi ends

  static constexpr std::string_view name = "drucker_prager";
  static constexpr std::array<ParameterSpec, 11> parameters{{
      youngs_modulus_spec,
      poisson_ratio_spec,
      cohesion_spec,
      friction_angle_spec,
      dilation_angle_spec,
      {"cone", Unit::choice, 0.0, 2.0, 0.0, 1.0, "plane_strain|outer|inner",
       "match of the cone to Coulomb's surface"},
      residual_cohesion_spec,
      residual_friction_angle_spec,
      softening_spec,
      softening_slip_spec,
      dilation_limit_spec,
  }};
  static constexpr auto members(auto& self) {
    return std::tie(self.youngs_modulus, self.poisson_ratio, self.cohesion, self.friction_angle,
                    self.dilation_angle, self.cone, self.residual_cohesion,
                    self.residual_friction_angle, self.softening, self.softening_slip,
                    self.dilation_limit);
  }
  static constexpr std::array<StateField, 1> state_fields{accumulated_plastic_strain};
  static constexpr bool yields = true;

  struct Constants {
    ElasticModuli elastic;
    ConeConstants cone;
    Cone match;
    Softening softening;
  };
  Constants prepare(const MaterialSetting& setting) const {
    return {elastic_moduli(youngs_modulus, poisson_ratio),
            cone_constants(strength().reduced(setting.strength_reduction), cone), cone,
            prepare_softening(*this, setting)};
  }
  static constexpr ElasticModuli moduli(const Constants& c) { return c.elastic; }

  /// Elastic step, then the return to the cone. Equation: E18, E21, P1, P4: the strength is that of
  /// the start of the step. Returns the plastic strain.
  template <class T>
  static SCARP_INLINE SymTensor<T> update(const Constants& c, const StrainIncrement<T>& step,
                                          SymTensor<T>& stress, History<T, 1>& history) {
    if (c.softening.acts) return update_softened(c, step, stress, history);
    stress = elastic_trial(c.elastic, step, stress);
    const SymTensor<T> trial = stress;
    history.change[0] = return_to_cone(c.elastic, c.cone, stress);
    return elastic_strain(c.elastic, trial - stress);
  }

  CoulombStrength strength() const { return {cohesion, friction_angle, dilation_angle}; }
  static double yield_function(const Constants& c, const SymTensor<double>& stress,
                               std::span<const double> history) {
    ConeConstants surface = c.cone;
    if (c.softening.acts && !history.empty())
      surface = cone_of(c.softening.strength(history[0], c.softening.loosest_density), c.match);
    return kernels::yield_function(surface, root_j2(deviator(stress)), trace(stress));
  }
  static constexpr std::array<ShownConstant, 3> shown{
      {{"alpha_phi", "-"}, {"k_c", "Pa"}, {"alpha_psi", "-"}}};
  static std::array<double, 3> show(const Constants& c) {
    return {c.cone.alpha_phi, c.cone.k_c, c.cone.alpha_psi};
  }
  bool softens() const { return strength_falls(*this); }
  std::optional<ParameterComplaint> complaint() const { return coulomb_complaint(*this, 6); }
  std::optional<ParameterComplaint> doubt(int dimension) const {
    if (dimension == 3 || cone != Cone::outer) return {};
    if (!(3.0 * cone_constants(strength(), cone).alpha_phi >= 1.0)) return {};
    return ParameterComplaint{5,
                              "the outer cone of such a friction angle never yields in plane "
                              "strain. Try cone = \"plane_strain\", or less than 42.2 deg."};
  }

 private:
  /// Apart, so that soil without softening runs the same instructions as if there were none.
  template <class T>
  [[gnu::noinline]] static SymTensor<T> update_softened(const Constants& c,
                                                        const StrainIncrement<T>& step,
                                                        SymTensor<T>& stress,
                                                        History<T, 1>& history) {
    stress = elastic_trial(c.elastic, step, stress);
    const SymTensor<T> trial = stress;
    const CoulombTangents<T> now = c.softening.strength(history.now[0], step.density);
    history.change[0] = return_to_cone(c.elastic, cone_of(now, c.match), stress);
    return elastic_strain(c.elastic, trial - stress);
  }
};

}  // namespace scarp::kernels
