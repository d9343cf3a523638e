// SPDX-License-Identifier: BSD-3-Clause
/// Strength that falls with plastic strain, and dilation that ends, for every model with Coulomb's
/// constants.
#pragma once

#include <cmath>
#include <optional>

#include "kernels/constitutive/model.hpp"

namespace scarp::kernels {

/// How the strength goes from peak to residual.
enum class SofteningLaw { exponential, linear };

/// Coulomb's constants as tangents: of one number for a material, or of a vector of particles.
template <class C>
struct CoulombTangents {
  C cohesion;  ///< [Pa]
  C friction;  ///< tan phi
  C dilation;  ///< tan psi
};

/// A slip is spread over so many particle spacings: bands are 2 to 3 spacings wide at every
/// resolution, so that a slip in metres means the same at each.
inline constexpr double band_spacings = 2.5;

/// Equation: P4. Strength c = c_r + (c_p - c_r) w, tan phi likewise, with the accumulated plastic
/// strain e: w = exp(-rate e) or max(0, 1 - rate e). Dilation ends below the density
/// `loosest_density`.
struct Softening {
  bool acts;  ///< false: nothing of this is computed
  bool linear;
  double rate;
  CoulombTangents<double> peak;
  double residual_cohesion;  ///< [Pa]
  double residual_friction;  ///< tan phi_r
  double loosest_density;    ///< [kg/m3]

  /// Of vectors of plastic strain and density.
  template <class T>
  SCARP_INLINE CoulombTangents<T> strength(const T& plastic_strain, const T& density) const {
    const T zero(0.0), one(1.0);
    const T decayed = T(rate) * plastic_strain;
    const T weight = linear ? larger(one - decayed, zero) : exponential(zero - decayed);
    const T friction = T(residual_friction) + T(peak.friction - residual_friction) * weight;
    return {T(residual_cohesion) + T(peak.cohesion - residual_cohesion) * weight, friction,
            choose(density > T(loosest_density), smaller(T(peak.dilation), friction), zero)};
  }
};

/// Whether the strength of a model with the parameters below falls with the slip.
template <class Soil>
constexpr bool strength_falls(const Soil& soil) {
  return soil.softening_slip > 0.0 && (soil.residual_cohesion != soil.cohesion ||
                                       soil.residual_friction_angle != soil.friction_angle);
}

/// Equation: E31 for both strengths. A slip delta in simple shear is the plastic strain
/// delta / (sqrt(3) band); the linear law has then reached the residual strength, the exponential
/// one has lost 95 % of the difference. `soil`: a model with the parameters below, for which
/// `coulomb_complaint` has no complaint.
template <class Soil>
Softening prepare_softening(const Soil& soil, const MaterialSetting& setting) {
  const double reduction = setting.strength_reduction;
  const CoulombStrength peak = soil.strength();
  const CoulombStrength p = peak.reduced(reduction);
  const CoulombStrength r =
      CoulombStrength{soil.residual_cohesion, soil.residual_friction_angle, 0.0}.reduced(reduction);
  const bool falls = strength_falls(soil);
  const bool ends = soil.dilation_limit < 1.0 && peak.dilation_angle > 0.0;
  const double per_strain = std::sqrt(3.0) * band_spacings * setting.spacing;
  const bool linear = soil.softening == SofteningLaw::linear;
  return {falls || ends,
          linear,
          falls ? (linear ? 1.0 : 3.0) * per_strain / soil.softening_slip : 0.0,
          {p.cohesion, std::tan(p.friction_angle), std::tan(p.dilation_angle)},
          falls ? r.cohesion : p.cohesion,
          falls ? std::tan(r.friction_angle) : std::tan(p.friction_angle),
          ends ? setting.reference_density * std::exp(-soil.dilation_limit) : 0.0};
}

inline constexpr ParameterSpec cohesion_spec{
    "cohesion", Unit::pressure, 0.0, 1e12, required, required, nullptr, "Coulomb's cohesion c"};
inline constexpr ParameterSpec friction_angle_spec{
    "friction_angle", Unit::angle, 0.0,     right_angle * 8.0 / 9.0,
    required,         required,    nullptr, "Coulomb's friction angle phi"};
inline constexpr ParameterSpec dilation_angle_spec{"dilation_angle",
                                                   Unit::angle,
                                                   0.0,
                                                   right_angle * 8.0 / 9.0,
                                                   0.0,
                                                   0.0,
                                                   nullptr,
                                                   "dilation angle psi, at most phi"};
inline constexpr ParameterSpec residual_cohesion_spec{
    "residual_cohesion",           Unit::pressure, 0.0, 1e12, required, required, nullptr,
    "cohesion after a large slip", "cohesion"};
inline constexpr ParameterSpec residual_friction_angle_spec{"residual_friction_angle",
                                                            Unit::angle,
                                                            0.0,
                                                            right_angle * 8.0 / 9.0,
                                                            required,
                                                            required,
                                                            nullptr,
                                                            "friction angle after a large slip",
                                                            "friction_angle"};
inline constexpr ParameterSpec softening_spec{
    "softening", Unit::choice, 0.0, 1.0, 0.0, 0.0, "exponential|linear", "law of the softening"};
inline constexpr ParameterSpec softening_slip_spec{
    "softening_slip",
    Unit::length,
    0.0,
    1e6,
    0.0,
    0.0,
    nullptr,
    "slip after which the residual strength is reached"};
inline constexpr ParameterSpec dilation_limit_spec{"dilation_limit",
                                                   Unit::none,
                                                   0.0,
                                                   1.0,
                                                   1.0,
                                                   1.0,
                                                   nullptr,
                                                   "volumetric strain at which dilation ends"};

/// What is wrong with Coulomb's constants and their softening. Pre: the soil's parameters begin as
/// E, nu, c, phi, psi, and the five above follow from index `residual` on.
template <class Soil>
std::optional<ParameterComplaint> coulomb_complaint(const Soil& soil, std::size_t residual) {
  if (const auto wrong = dilation_complaint(soil.strength(), 4)) return wrong;
  if (soil.residual_cohesion > soil.cohesion)
    return ParameterComplaint{residual, "it is above the cohesion. Try at most the cohesion."};
  if (soil.residual_friction_angle > soil.friction_angle) {
    return ParameterComplaint{residual + 1,
                              "it is above the friction angle. Try at most the friction angle."};
  }
  const bool weaker =
      soil.residual_cohesion < soil.cohesion || soil.residual_friction_angle < soil.friction_angle;
  if (weaker && !(soil.softening_slip > 0.0)) {
    return ParameterComplaint{residual + 3,
                              "a residual strength needs the slip after which it is reached. Try "
                              "\"0.2 m\"."};
  }
  return {};
}

}  // namespace scarp::kernels
