// SPDX-License-Identifier: BSD-3-Clause
/// See the case's README for each derivation.

#include "validation/cases/element/closed_forms.hpp"

#include <cmath>
#include <numbers>

namespace scarp::validation {
namespace {
constexpr double root3 = std::numbers::sqrt3;
}

PlasticSoil::PlasticSoil(const ElementResult& r)
    : alpha_phi(r.constants.at("alpha_phi")),
      k_c(r.constants.at("k_c")),
      alpha_psi(r.constants.at("alpha_psi")),
      bulk_modulus(r.bulk_modulus),
      shear_modulus(r.shear_modulus) {}

double PlasticSoil::youngs_modulus() const {
  return 9.0 * bulk_modulus * shear_modulus / (3.0 * bulk_modulus + shear_modulus);
}

double triaxial_strength(const PlasticSoil& soil, double b) {
  return (b / root3 + soil.k_c + 2.0 * soil.alpha_phi * b) / (1.0 / root3 - soil.alpha_phi);
}

double triaxial_extension_strength(const PlasticSoil& soil, double b) {
  return (b / root3 - soil.k_c - 2.0 * soil.alpha_phi * b) / (1.0 / root3 + soil.alpha_phi);
}

TriaxialStrains triaxial_strains(const PlasticSoil& soil, double b, double axial) {
  const double deviator = triaxial_strength(soil, b) - b;
  const double plastic_axial = axial - deviator / soil.youngs_modulus();
  // Axial plastic strain lambda (1/sqrt(3) - b), volumetric 3 b lambda, accumulated lambda/sqrt(3).
  const double multiplier = plastic_axial / (1.0 / root3 - soil.alpha_psi);
  return {-deviator / (3.0 * soil.bulk_modulus), 3.0 * soil.alpha_psi * multiplier,
          multiplier / root3};
}

PlaneStrainStrength plane_strain_strength(const PlasticSoil& soil, double b) {
  const double a = soil.alpha_phi, d = soil.alpha_psi, w = std::sqrt(1.0 - 3.0 * d * d);
  const double j = (soil.k_c + 3.0 * a * b) / (1.0 - 3.0 * a * (w + d));
  return {b + 2.0 * w * j, b + (3.0 * d + w) * j};
}

double simple_shear_strength(const PlasticSoil& soil, double b) {
  const double a = soil.alpha_phi, d = soil.alpha_psi;
  // The stress turns by J/G of what it flows, about 1e-3, so each round adds three digits.
  double j = soil.k_c + 3.0 * a * b, t = 1.0, turn = 0.0;
  for (int round = 0; round < 100; ++round) {
    const double e = j / soil.shear_modulus, x = -2.0 * d + turn, y = 4.0 * d - turn;
    t = std::sqrt(1.0 - 0.5 * (x * x + y * y + 4.0 * d * d));
    const double flow = (1.0 + 3.0 * d * e - e * turn) / t;
    turn = e * t / flow;
    j = soil.k_c + 3.0 * a * (b + j * (4.0 * d - turn));
  }
  return j * t;
}

double isotropic_extension(const PlasticSoil& soil, double b, double extension) {
  const double elastic = 3.0 * (soil.bulk_modulus * extension - b);
  return soil.alpha_phi > 0.0 ? std::fmin(elastic, soil.k_c / soil.alpha_phi) : elastic;
}

ShearWithDilation shear_with_dilation(const PlasticSoil& soil, double b, double shear,
                                      double dilation) {
  const double a = soil.alpha_phi, d = soil.alpha_psi, bulk = soil.bulk_modulus,
               g = soil.shear_modulus;
  const double elastic_i1 = 3.0 * (bulk * dilation - b), elastic_j = g * shear;
  // Straight in strain up to the cone and along it, so that all of the excess f flows at once.
  const double excess = elastic_j - soil.strength(elastic_i1);
  if (excess <= 0.0) return {elastic_i1, elastic_j, 0.0, false};
  const double multiplier = excess / (g + 9.0 * bulk * a * d);
  const double j = elastic_j - g * multiplier;
  if (j > 0.0) {
    return {elastic_i1 - 9.0 * bulk * d * multiplier, j, multiplier / root3, false};
  }
  return {soil.k_c / a, 0.0, shear / root3, true};
}

ElasticShear elastic_simple_shear(double bulk_modulus, double shear_modulus, double shear) {
  const double lame = bulk_modulus - 2.0 / 3.0 * shear_modulus;
  const double q = std::sqrt(0.5 * (1.0 + lame / (lame + 2.0 * shear_modulus)));
  return {std::sin(q * shear) / q, 2.0 * (1.0 - std::cos(q * shear))};
}

}  // namespace scarp::validation
