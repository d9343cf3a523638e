// SPDX-License-Identifier: BSD-3-Clause
/// Closed forms of Drucker-Prager soil along the paths of the element tests, derived in the case's
/// README. Stress positive in tension, pressures and strengths in Pa.
#pragma once

#include "engine/element/element_path.hpp"

namespace scarp::validation {

/// f = sqrt(J2) + alpha_phi I1 - k_c, g = sqrt(J2) + alpha_psi I1, and the moduli [Pa].
struct PlasticSoil {
  double alpha_phi, k_c, alpha_psi, bulk_modulus, shear_modulus;

  explicit PlasticSoil(const ElementResult& result);
  /// E of K and G [Pa].
  double youngs_modulus() const;
  /// sqrt(J2) on the cone under the first invariant `i1` [Pa].
  double strength(double i1) const { return k_c - alpha_phi * i1; }
};

/// Axial stress magnitude at failure under lateral pressure `b` [Pa]: compression, extension.
double triaxial_strength(const PlasticSoil& soil, double b);
double triaxial_extension_strength(const PlasticSoil& soil, double b);

/// Strains of triaxial compression to the axial strain `axial`, past failure [-].
struct TriaxialStrains {
  double elastic_volumetric;  ///< at failure, negative
  double plastic_volumetric;
  double accumulated_plastic;
};
TriaxialStrains triaxial_strains(const PlasticSoil& soil, double b, double axial);

/// Magnitudes of the axial stress and of the stress across the plane at failure in plane strain
/// under lateral pressure `b` [Pa].
struct PlaneStrainStrength {
  double axial, across;
};
PlaneStrainStrength plane_strain_strength(const PlasticSoil& soil, double b);

/// Shear stress of steady simple shear under constant normal pressure `b` [Pa], with the Jaumann
/// rate.
double simple_shear_strength(const PlasticSoil& soil, double b);

/// I1 of isotropic extension by the volumetric strain `extension` from the pressure `b` [Pa].
double isotropic_extension(const PlasticSoil& soil, double b, double extension);

/// Pure shear with dilation, both strains rising in proportion from the isotropic pressure `b`:
/// elastic, along the cone, at the apex.
struct ShearWithDilation {
  double first_invariant, root_j2;  ///< [Pa]
  double accumulated_plastic;
  bool at_apex;
};
/// `shear`: engineering shear strain gamma; `dilation`: volumetric strain, above 0.
ShearWithDilation shear_with_dilation(const PlasticSoil& soil, double b, double shear,
                                      double dilation);

/// Shear stress and sigma_xx + b over G of elastic simple shear by `shear` under constant sigma_yy
/// (Jaumann rate).
struct ElasticShear {
  double shear_stress, normal_stress;
};
ElasticShear elastic_simple_shear(double bulk_modulus, double shear_modulus, double shear);

}  // namespace scarp::validation
