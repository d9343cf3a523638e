// SPDX-License-Identifier: BSD-3-Clause
/// Drucker-Prager plasticity at one point: return mapping, and the paper's rate form.
#pragma once

#include "kernels/particle_view.hpp"
#include "kernels/point_math.hpp"
#include "kernels/tensor.hpp"

namespace scarp::kernels {

/// f = sqrt(J2) + alpha_phi I1 - k_c. Equation: E9.
template <class T>
SCARP_INLINE T yield_function(const StressPassConstants& c, const T& root_j2, const T& i1) {
  return root_j2 + T(c.alpha_phi) * i1 - T(c.k_c);
}

template <class T>
SCARP_INLINE T root_j2(const SymTensor<T>& deviatoric_stress) {
  return root(T(0.5) * contract(deviatoric_stress, deviatoric_stress));
}

/// Puts a trial stress back on the yield surface along the plastic potential, cone or apex, in
/// closed form, and returns the increment of the equivalent deviatoric plastic strain sqrt(2/3 de_p
/// : de_p). Equation: P1; dlambda = f/(G + 9 K alpha_phi alpha_psi), sqrt(J2) -= G dlambda, I1 -= 9
/// K alpha_psi dlambda; if sqrt(J2) would turn negative: I1 = k_c/alpha_phi, s = 0. Limits: exact
/// for one step of any size.
template <class T>
SCARP_INLINE T return_to_yield_surface(const StressPassConstants& c, SymTensor<T>& stress) {
  const T zero(0.0), one(1.0);
  const T i1 = trace(stress);
  SymTensor<T> s = deviator(stress);
  const T j = root_j2(s);
  const T f = yield_function(c, j, i1);
  const auto yields = f > zero;
  if (none_of(yields)) return zero;
  const T multiplier =
      f * T(1.0 / (c.shear_modulus + 9.0 * c.bulk_modulus * c.alpha_phi * c.alpha_psi));
  const T j_returned = j - T(c.shear_modulus) * multiplier;
  const auto to_cone = j_returned >= zero;
  // Without friction there is no apex: j_returned = k_c, which without cohesion too is 0 but for
  // its sign.
  const T apex = c.alpha_phi > 0.0 ? T(c.k_c / c.alpha_phi) : i1;
  const T i1_new = choose(to_cone, i1 - T(9.0 * c.bulk_modulus * c.alpha_psi) * multiplier, apex);
  // j = 0 cannot reach the cone except at the apex, where s = 0 anyway.
  const T shrink = choose(to_cone, j_returned / larger(j, T(1e-300)), zero);
  const T scale = choose(yields, shrink, one);
  const T mean = choose(yields, i1_new, i1) * T(1.0 / 3.0);
  stress = {scale * s.xx + mean, scale * s.yy + mean, scale * s.zz + mean,
            scale * s.xy,        scale * s.yz,        scale * s.zx};
  const T increment =
      choose(to_cone, multiplier, j * T(1.0 / c.shear_modulus)) * T(0.57735026918962576);
  return choose(yields, increment, zero);
}

/// Subtracts the plastic part of the stress rate where the stress `at` is outside the yield
/// surface, and returns the equivalent deviatoric plastic strain. Equation: E13, E22; the
/// multiplier is held >= 0, since Eq. 22 turns negative on unloading. `on_surface` widens the test
/// by 1e-6 of the strength, for stresses that a correction has just put on the surface.
template <class T>
SCARP_INLINE T subtract_plastic_rate(const StressPassConstants& c, const SymTensor<T>& at,
                                     const SymTensor<T>& strain_increment, bool on_surface,
                                     SymTensor<T>& stress) {
  const T zero(0.0);
  const SymTensor<T> s = deviator(at);
  const T j = larger(root_j2(s), T(1e-30));  // so that G/j stays finite
  const T i1 = trace(at);
  const T margin = on_surface ? T(1e-6) * (T(c.k_c) - T(c.alpha_phi) * i1) : zero;
  const auto yields = yield_function(c, j, i1) > -margin;
  const T numerator = T(3.0 * c.alpha_phi * c.bulk_modulus) * trace(strain_increment) +
                      T(c.shear_modulus) / j * contract(s, strain_increment);
  const T full =
      numerator * T(1.0 / (9.0 * c.alpha_phi * c.alpha_psi * c.bulk_modulus + c.shear_modulus));
  const T multiplier = choose(yields, larger(full, zero), zero);
  const T deviatoric = multiplier * T(c.shear_modulus) / j;
  stress = stress - isotropic(multiplier * T(3.0 * c.alpha_psi * c.bulk_modulus)) - deviatoric * s;
  return multiplier * T(0.57735026918962576);
}

/// Bui's two corrections (2008): normal stresses are shifted back to the apex, then the deviator is
/// scaled back to the surface at constant I1. Equation: P2.
template <class T>
SCARP_INLINE void correct_stress(const StressPassConstants& c, SymTensor<T>& stress) {
  const T zero(0.0), one(1.0);
  if (c.alpha_phi > 0.0) {
    const T excess = larger(trace(stress) - T(c.k_c / c.alpha_phi), zero) * T(1.0 / 3.0);
    stress = stress - isotropic(excess);
  }
  const T i1 = trace(stress);
  const SymTensor<T> s = deviator(stress);
  const T j = root_j2(s);
  const T strength = larger(T(c.k_c) - T(c.alpha_phi) * i1, zero);
  const T scale = choose(j > strength, strength / larger(j, T(1e-300)), one);
  stress = isotropic(i1 * T(1.0 / 3.0)) + scale * s;
}

}  // namespace scarp::kernels
