// SPDX-License-Identifier: BSD-3-Clause
/// Non-associated Mohr-Coulomb model with a tension cut-off.
#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "kernels/constitutive/linear_elastic.hpp"
#include "kernels/constitutive/model.hpp"
#include "kernels/constitutive/principal.hpp"
#include "kernels/constitutive/softening.hpp"

namespace scarp::kernels {

/// Coulomb's surface in principal stresses, of one number or of a vector of particles.
template <class C>
struct CoulombSurface {
  C sine;              ///< sin phi
  C dilation;          ///< sin psi
  C twice_c_cosine;    ///< 2 c cos phi [Pa]
  C apex;              ///< c cot phi [Pa]; without friction there is none
  C tensile_strength;  ///< s_t [Pa]
};

template <class C>
SCARP_INLINE CoulombSurface<C> coulomb_surface(const CoulombTangents<C>& t,
                                               const C& tensile_strength) {
  const C one(1.0);
  const C cosine = one / root(one + t.friction * t.friction);
  const C psi_cosine = one / root(one + t.dilation * t.dilation);
  return {t.friction * cosine, t.dilation * psi_cosine, C(2.0) * t.cohesion * cosine,
          t.cohesion / larger(t.friction, C(1e-300)), tensile_strength};
}

/// f = s1 - s3 + (s1 + s3) sin phi - 2 c cos phi of the largest and the smallest principal stress.
/// Equation: P3.
template <class C, class T>
SCARP_INLINE T coulomb_function(const CoulombSurface<C>& c, const T& s1, const T& s3) {
  return s1 - s3 + (s1 + s3) * T(c.sine) - T(c.twice_c_cosine);
}

/// Principal stresses s, in order, back on Coulomb's surface where they are outside: on its plane,
/// on the edge of the side the plane was left by, or on its apex. Equation: P3; de Souza Neto et
/// al. (2008), chapter 8.
template <class C, class T>
SCARP_INLINE void return_to_coulomb(const ElasticModuli& moduli, const CoulombSurface<C>& c,
                                    T (&s)[3]) {
  const C g(moduli.shear_modulus), k(moduli.bulk_modulus), one(1.0), two(2.0), four(4.0);
  const C third(1.0 / 3.0), sf = c.sine, sp = c.dilation, steep = four * k * sf * sp;
  const T u1(two * g * (one + sp * third) + two * k * sp);
  const T u2((four * third * g - two * k) * sp);
  const T u3(two * g * (one - sp * third) - two * k * sp);
  const C ca = four * g * (one + sf * sp * third) + steep;
  const C cr = two * g * (one + sf + sp - sf * sp * third) + steep;
  const C cl = two * g * (one - sf - sp - sf * sp * third) + steep;
  const T zero(0.0), a(ca);
  const T f = coulomb_function(c, s[0], s[2]);
  const auto outside = f > zero;
  const T d = f * T(one / ca);
  const T plane[3] = {s[0] - u1 * d, s[1] + u2 * d, s[2] + u3 * d};
  // Edge s2 = s3 or s1 = s2, by the side of the plane's flow through its middle.
  const auto lower = T(one - sp) * s[0] - T(two) * s[1] + T(one + sp) * s[2] > zero;
  const T fb = choose(lower, coulomb_function(c, s[0], s[1]), coulomb_function(c, s[1], s[2]));
  const T b = choose(lower, T(cr), T(cl));
  const T scale = T(1.0) / (a * a - b * b);
  const T d2 = (a * f - b * fb) * scale, e2 = (a * fb - b * f) * scale;
  const T edge[3] = {s[0] - u1 * d2 - choose(lower, u1, zero - u2) * e2,
                     s[1] + u2 * d2 + choose(lower, u3, zero - u1) * e2,
                     s[2] + u3 * d2 + choose(lower, u2, u3) * e2};
  const T mean = (s[0] + s[1] + s[2]) * T(1.0 / 3.0);
  const T apex = choose(T(sf) > zero, T(c.apex), mean);
  const auto on_plane = (plane[0] >= plane[1]) & (plane[1] >= plane[2]);
  const auto on_edge = edge[0] >= edge[2];
  for (int i = 0; i < 3; ++i) {
    const T there = choose(on_plane, plane[i], choose(on_edge, edge[i], apex));
    s[i] = choose(outside, there, s[i]);
  }
}

/// Principal stresses s, in order, back within the tension cut-off s_i <= s_t along its normals.
template <class C, class T>
SCARP_INLINE void return_to_cut_off(const ElasticModuli& moduli, const CoulombSurface<C>& c,
                                    T (&s)[3]) {
  const double along = moduli.wave_modulus();
  const double across = moduli.bulk_modulus - 2.0 / 3.0 * moduli.shear_modulus;
  const T limit(c.tensile_strength), zero(0.0);
  // One plane, then the edge of two, then the corner of three.
  const T first = larger(s[0] - limit, zero);
  const T alone = s[1] - T(across / along) * first;
  const auto two_act = alone > limit;
  const T both = larger(s[0] - limit, zero) + larger(s[1] - limit, zero);
  const T third_one = s[2] - T(across / along) * first;
  const T third_two = s[2] - T(across / (along + across)) * both;
  s[0] = smaller(s[0], limit);
  s[1] = choose(two_act, limit, alone);
  s[2] = smaller(choose(two_act, third_two, third_one), limit);
}

/// Both surfaces: where neither return alone is inside the other, their common edge or corner.
template <class C, class T>
SCARP_INLINE void return_to_cut_surface(const ElasticModuli& moduli, const CoulombSurface<C>& c,
                                        T (&s)[3]) {
  const double along = moduli.wave_modulus();
  const double across = moduli.bulk_modulus - 2.0 / 3.0 * moduli.shear_modulus;
  const C g(moduli.shear_modulus), k(moduli.bulk_modulus), one(1.0), two(2.0), four(4.0);
  const C third(1.0 / 3.0), sp = c.dilation;
  const T u1(two * g * (one + sp * third) + two * k * sp);
  const T u2((four * third * g - two * k) * sp);
  const T u3(two * g * (one - sp * third) - two * k * sp);
  const T limit(c.tensile_strength);
  T sheared[3] = {s[0], s[1], s[2]}, cut[3] = {s[0], s[1], s[2]};
  return_to_coulomb(moduli, c, sheared);
  return_to_cut_off(moduli, c, cut);
  const auto shear_is_enough = sheared[0] <= limit;
  const auto cut_is_enough = coulomb_function(c, cut[0], cut[2]) <= T(0.0);
  // s1 = s_t and f = 0: multipliers of the plane and of the cut-off from s1 and s3.
  const T smallest = (T(one + c.sine) * limit - T(c.twice_c_cosine)) / T(one - c.sine);
  const T over1 = s[0] - limit, over3 = s[2] - smallest;
  const T determinant = u1 * T(across) + u3 * T(along);
  const T shear = (T(across) * over1 - T(along) * over3) / determinant;
  const T tension = (u3 * over1 + u1 * over3) / determinant;
  const T middle = s[1] + u2 * shear - T(across) * tension;
  const T corner[3] = {limit, smaller(larger(middle, smallest), limit), smallest};
  for (int i = 0; i < 3; ++i) {
    s[i] = choose(shear_is_enough, sheared[i], choose(cut_is_enough, cut[i], corner[i]));
  }
}

struct MohrCoulomb {
  double youngs_modulus = required;                    ///< E [Pa]
  double poisson_ratio = required;                     ///< nu [-]
  double cohesion = required;                          ///< c [Pa]
  double friction_angle = required;                    ///< phi [rad]
  double dilation_angle = 0.0;                         ///< psi, at most phi [rad]
  double tensile_strength = 1e12;                      ///< s_t; no more than c cot phi [Pa]
  double residual_cohesion = cohesion;                 ///< after `softening_slip` [Pa]
  double residual_friction_angle = friction_angle;     ///< [rad]
  SofteningLaw softening = SofteningLaw::exponential;  ///< from peak to residual
  double softening_slip = 0.0;                         ///< [m]
  double dilation_limit = 1.0;                         ///< volumetric strain where psi ends

  static constexpr std::string_view name = "mohr_coulomb";
  static constexpr std::array<ParameterSpec, 11> parameters{{
      youngs_modulus_spec,
      poisson_ratio_spec,
      cohesion_spec,
      friction_angle_spec,
      dilation_angle_spec,
      {"tensile_strength", Unit::pressure, 0.0, 1e12, 1e12, 1e12, nullptr,
       "largest tension; beyond c cot phi it has no effect"},
      residual_cohesion_spec,
      residual_friction_angle_spec,
      softening_spec,
      softening_slip_spec,
      dilation_limit_spec,
  }};
  static constexpr auto members(auto& self) {
    return std::tie(self.youngs_modulus, self.poisson_ratio, self.cohesion, self.friction_angle,
                    self.dilation_angle, self.tensile_strength, self.residual_cohesion,
                    self.residual_friction_angle, self.softening, self.softening_slip,
                    self.dilation_limit);
  }
  static constexpr std::array<StateField, 1> state_fields{accumulated_plastic_strain};
  static constexpr bool yields = true;

  struct Constants {
    ElasticModuli elastic;
    CoulombSurface<double> surface;
    bool cut_off;  ///< whether the tensile strength is below the apex
    Softening softening;
  };
  Constants prepare(const MaterialSetting& setting) const {
    const CoulombStrength reduced = strength().reduced(setting.strength_reduction);
    const CoulombTangents<double> tangents{reduced.cohesion, std::tan(reduced.friction_angle),
                                           std::tan(reduced.dilation_angle)};
    const CoulombSurface<double> surface =
        coulomb_surface(tangents, tensile_strength / setting.strength_reduction);
    const bool cut_off =
        surface.sine == 0.0 ? tensile_strength < 1e12 : surface.tensile_strength < surface.apex;
    return {elastic_moduli(youngs_modulus, poisson_ratio), surface, cut_off,
            prepare_softening(*this, setting)};
  }
  static constexpr ElasticModuli moduli(const Constants& c) { return c.elastic; }

  /// Elastic step, then the return in principal stresses along the trial's axes. Equation: E18,
  /// E21, P3, P4: the strength is that of the start of the step. Returns the plastic strain.
  template <class T>
  static SCARP_INLINE SymTensor<T> update(const Constants& c, const StrainIncrement<T>& step,
                                          SymTensor<T>& stress, History<T, 1>& history) {
    if (!c.softening.acts) return flow(c, c.surface, step, stress, history);
    const CoulombTangents<T> now = c.softening.strength(history.now[0], step.density);
    return flow(c, coulomb_surface(now, T(c.surface.tensile_strength)), step, stress, history);
  }

  CoulombStrength strength() const { return {cohesion, friction_angle, dilation_angle}; }
  static double yield_function(const Constants& c, const SymTensor<double>& stress,
                               std::span<const double> history) {
    const Principal<double> s = principal(stress);
    CoulombSurface<double> surface = c.surface;
    if (c.softening.acts && !history.empty()) {
      const auto now = c.softening.strength(history[0], c.softening.loosest_density);
      surface = coulomb_surface(now, c.surface.tensile_strength);
    }
    const double shear = coulomb_function(surface, s.value[0], s.value[2]);
    return c.cut_off ? std::fmax(shear, s.value[0] - surface.tensile_strength) : shear;
  }
  bool softens() const { return strength_falls(*this); }
  std::optional<ParameterComplaint> complaint() const { return coulomb_complaint(*this, 6); }

 private:
  template <class C, class T>
  static SCARP_INLINE SymTensor<T> flow(const Constants& c, const CoulombSurface<C>& surface,
                                        const StrainIncrement<T>& step, SymTensor<T>& stress,
                                        History<T, 1>& history) {
    const T zero(0.0);
    stress = elastic_trial(c.elastic, step, stress);
    history.change[0] = zero;
    // Most of the soil is within the cone that touches the surface from inside, or all of it is.
    if (none_of(outside_of_inner_cone(c, surface, stress))) return isotropic(zero);
    const Principal<T> trial = principal(stress);
    T back[3] = {trial.value[0], trial.value[1], trial.value[2]};
    if (c.cut_off) {
      return_to_cut_surface(c.elastic, surface, back);
    } else {
      return_to_coulomb(c.elastic, surface, back);
    }
    const T change[3] = {trial.value[0] - back[0], trial.value[1] - back[1],
                         trial.value[2] - back[2]};
    const T mean = (change[0] + change[1] + change[2]) * T(1.0 / 3.0);
    const T x = change[0] - mean, y = change[1] - mean, z = change[2] - mean;
    history.change[0] =
        root(T(2.0 / 3.0) * (x * x + y * y + z * z)) * T(0.5 / c.elastic.shear_modulus);
    const SymTensor<T> lost = along_axes(trial, change);
    stress = stress - lost;
    return elastic_strain(c.elastic, lost);
  }

  /// The cone of plane strain (E11) lies inside Coulomb's surface and touches it; a tension
  /// anywhere asks for the cut-off.
  template <class C, class T>
  static SCARP_INLINE auto outside_of_inner_cone(const Constants& c,
                                                 const CoulombSurface<C>& surface,
                                                 const SymTensor<T>& stress) {
    const C below = root(C(9.0) + C(3.0) * surface.sine * surface.sine);
    const T i1 = trace(stress), j = root_j2(deviator(stress));
    const T f = j + T(surface.sine / below) * i1 - T(C(1.5) * surface.twice_c_cosine / below);
    // s1 <= I1/3 + 2 J/sqrt(3)
    const T largest = i1 * T(1.0 / 3.0) + T(1.1547005383792515) * j;
    const T tension = c.cut_off ? largest - T(surface.tensile_strength) : f;
    return larger(f, tension) > T(0.0);
  }
};

}  // namespace scarp::kernels
